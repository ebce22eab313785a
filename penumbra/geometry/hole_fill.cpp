// SPDX-License-Identifier: MIT
#include "penumbra/geometry/hole_fill.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace penumbra {
namespace {

using Edge = std::array<std::uint32_t, 2>;

/// Longer loops are filled around their middle, which keeps the triangles short.
constexpr std::size_t longest_corner_fan = 4;

void fill_loop(std::span<const std::uint32_t> loop, std::span<const Vec3f> positions,
               std::vector<FlatTriangle>& fills) {
  if (loop.size() <= longest_corner_fan) {
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
      fills.push_back({positions[loop[0]], positions[loop[i]], positions[loop[i + 1]]});
    return;
  }
  Vec3d sum;
  for (const std::uint32_t v : loop) sum += Vec3d(positions[v]);
  const Vec3f middle(sum / static_cast<double>(loop.size()));
  for (std::size_t i = 0; i < loop.size(); ++i)
    fills.push_back({middle, positions[loop[i]], positions[loop[(i + 1) % loop.size()]]});
}

/// Both directions of the edges, by the vertex they leave.
struct Ways {
  struct Way {
    std::uint32_t from, to;
    std::size_t edge;
  };
  std::vector<Way> ways;
  std::vector<bool> is_used;  // by edge

  explicit Ways(std::span<const Edge> edges) : is_used(edges.size(), false) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      ways.push_back({edges[i][0], edges[i][1], i});
      ways.push_back({edges[i][1], edges[i][0], i});
    }
    std::sort(ways.begin(), ways.end(), [](const Way& a, const Way& b) {
      return a.from != b.from ? a.from < b.from : a.edge < b.edge;
    });
  }

  /// An unused way out of the vertex, or nullptr.
  const Way* next(std::uint32_t vertex) const {
    auto way = std::lower_bound(ways.begin(), ways.end(), vertex,
                                [](const Way& a, std::uint32_t v) { return a.from < v; });
    for (; way != ways.end() && way->from == vertex; ++way)
      if (!is_used[way->edge]) return &*way;
    return nullptr;
  }
};

/// Walks unused edges from `start` until none is left, and fills each loop as it closes.
void walk_loops(Ways& ways, std::uint32_t start, std::span<const Vec3f> positions,
                std::vector<FlatTriangle>& fills) {
  std::vector<std::uint32_t> path{start};
  while (const Ways::Way* way = ways.next(path.back())) {
    ways.is_used[way->edge] = true;
    const auto met = std::find(path.begin(), path.end(), way->to);
    if (met == path.end()) {
      path.push_back(way->to);
      continue;
    }
    fill_loop({met, path.end()}, positions, fills);
    path.erase(met + 1, path.end());
  }
}

}  // namespace

std::vector<FlatTriangle> hole_fills(std::span<const Edge> odd_edges,
                                     std::span<const Vec3f> positions) {
  Ways ways(odd_edges);
  std::vector<FlatTriangle> fills;
  for (std::size_t i = 0; i < odd_edges.size(); ++i)
    if (!ways.is_used[i]) walk_loops(ways, odd_edges[i][0], positions, fills);
  return fills;
}

}  // namespace penumbra
