// SPDX-License-Identifier: MIT
#include "penumbra/geometry/flat_pieces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <utility>

#include "penumbra/geometry/mesh_edges.h"
#include "penumbra/geometry/planar_hull.h"

namespace penumbra {
namespace {

/// Of its area: how much of its hull a piece may leave empty and count as convex.
constexpr double convex_tolerance = 1e-4;
/// Of the surface's size: what lies so near a line lies on it. Files round coordinates.
constexpr double line_tolerance = 1e-5;
/// Of a piece's size.
constexpr double long_edge = 0.15;
constexpr std::size_t most_cuts = 24;

/// Points with a x + b y > c are left of it.
struct Line {
  double a = 0, b = 0, c = 0;
  bool is_edge = true;  ///< along a long edge: what it cuts off is likelier to be convex
  double height(PlanePoint p) const { return a * p.x + b * p.y - c; }
};

struct Piece {
  std::vector<PlaneTriangle> triangles;  ///< not kept up by `join`
  FlatPiece flat;
  double empty = 0;  ///< of the hull's area
  bool is_done = false;
};

bool is_before(PlanePoint a, PlanePoint b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

double area_of(const PlaneTriangle& t) { return 0.5 * std::abs(twice_area(t[0], t[1], t[2])); }

std::vector<PlanePoint> points_of(std::span<const PlaneTriangle> triangles) {
  std::vector<PlanePoint> points;
  points.reserve(3 * triangles.size());
  for (const PlaneTriangle& t : triangles) points.insert(points.end(), t.begin(), t.end());
  return points;
}

/// From its leftmost corner to the one farthest from that.
double size_of(std::span<const PlanePoint> ring) {
  double size = 0;
  for (const PlanePoint p : ring)
    size = std::max(size, std::hypot(p.x - ring[0].x, p.y - ring[0].y));
  return size;
}

bool is_convex(const FlatPiece& flat) {
  return area(flat.ring) <= flat.area * (1 + convex_tolerance);
}

/// Rings of many corners without those that are farthest in none of 512 directions: 3·10⁻⁵ of a
/// circle's area.
std::vector<PlanePoint> thinned(std::vector<PlanePoint> ring) {
  constexpr std::size_t most = 512;
  if (ring.size() <= most) return ring;
  std::vector<PlanePoint> few;
  // The farthest corner goes round the ring as the direction turns, from the leftmost one on.
  std::size_t at = 0;
  for (std::size_t i = 0; i < most; ++i) {
    const double angle = std::numbers::pi + 2 * std::numbers::pi * static_cast<double>(i) / most;
    const double a = std::cos(angle), b = std::sin(angle);
    const auto reach = [&](std::size_t j) {
      const PlanePoint p = ring[j % ring.size()];
      return a * p.x + b * p.y;
    };
    while (at < 2 * ring.size() && reach(at + 1) > reach(at)) ++at;
    few.push_back(ring[at % ring.size()]);
  }
  return planar_hull(std::move(few));
}

Piece piece_of(std::vector<PlaneTriangle> triangles) {
  Piece piece;
  for (const PlaneTriangle& t : triangles) piece.flat.area += area_of(t);
  piece.flat.ring = thinned(planar_hull(points_of(triangles)));
  piece.empty = area(piece.flat.ring) - piece.flat.area;
  piece.is_done = is_convex(piece.flat);
  piece.triangles = std::move(triangles);
  return piece;
}

/// Where an edge meets the line; the same from either end.
PlanePoint crossing(const Line& line, PlanePoint a, PlanePoint b) {
  if (is_before(b, a)) std::swap(a, b);
  const double ha = line.height(a), hb = line.height(b), s = ha / (ha - hb);
  return {a.x + (b.x - a.x) * s, a.y + (b.y - a.y) * s};
}

using Sides = std::array<std::vector<PlaneTriangle>, 2>;  ///< right of the line, left of it

/// What of a triangle lies on one side, as a fan.
void add_side(const PlaneTriangle& t, const std::array<double, 3>& height, double side,
              std::vector<PlaneTriangle>& to, const Line& line) {
  std::vector<PlanePoint> ring;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (height[i] * side >= 0) ring.push_back(t[i]);
    if (height[i] * height[j] < 0) ring.push_back(crossing(line, t[i], t[j]));
  }
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) to.push_back({ring[0], ring[i], ring[i + 1]});
}

Sides cut(std::span<const PlaneTriangle> triangles, const Line& line, double tolerance) {
  Sides sides;
  for (const PlaneTriangle& t : triangles) {
    std::array<double, 3> height;
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double h = line.height(t[i]);
      sum += h;
      height[i] = std::abs(h) <= tolerance ? 0 : h;
    }
    const auto [low, high] = std::minmax({height[0], height[1], height[2]});
    if (low < 0 && high > 0) {
      add_side(t, height, -1, sides[0], line);
      add_side(t, height, 1, sides[1], line);
    } else {
      sides[sum > 0 ? 1 : 0].push_back(t);
    }
  }
  return sides;
}

std::optional<Line> line_through(PlanePoint a, PlanePoint b) {
  if (is_before(b, a)) std::swap(a, b);
  const double dx = b.x - a.x, dy = b.y - a.y, long_ = std::hypot(dx, dy);
  if (!(long_ > 0)) return {};
  const double na = -dy / long_, nb = dx / long_;
  return Line{na, nb, na * a.x + nb * a.y};
}

using Edge = std::array<PlanePoint, 2>;

/// Edges of one triangle: the surface's outline, and edges that meet others along a part. Evenly
/// fewer where they are very many.
std::vector<Edge> outline_of(const Piece& piece) {
  constexpr std::size_t most_edges = 6000;
  std::vector<Edge> edges;
  for (const PlaneTriangle& t : piece.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const PlanePoint a = t[i], b = t[(i + 1) % 3];
      edges.push_back(is_before(b, a) ? Edge{b, a} : Edge{a, b});
    }
  std::sort(edges.begin(), edges.end(), [](const Edge& e, const Edge& f) {
    return e[0] == f[0] ? is_before(e[1], f[1]) : is_before(e[0], f[0]);
  });
  std::vector<Edge> outline;
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    while (end < edges.size() && edges[end] == edges[i]) ++end;
    if (end - i == 1) outline.push_back(edges[i]);
  }
  const std::size_t step = outline.size() / most_edges + 1;
  std::vector<Edge> few;
  for (std::size_t i = 0; i < outline.size(); i += step) few.push_back(outline[i]);
  return few;
}

/// Lines along the outline, those with the longest edges first, and through the middle.
std::vector<Line> candidate_lines(const Piece& piece, std::span<const Edge> outline,
                                  double tolerance) {
  const std::size_t most = std::clamp<std::size_t>(60'000 / outline.size(), 8, 48);
  std::vector<std::pair<double, Line>> edges;
  for (const Edge& e : outline) {
    const double long_ = std::hypot(e[1].x - e[0].x, e[1].y - e[0].y);
    if (const auto line = line_through(e[0], e[1]); line && long_ > 4 * tolerance)
      edges.emplace_back(long_, *line);
  }
  std::stable_sort(edges.begin(), edges.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Line> lines;
  for (const auto& [long_, line] : edges) {
    if (lines.size() == most) break;
    double low = 0, high = 0;
    for (const PlanePoint p : piece.flat.ring)
      low = std::min(low, line.height(p)), high = std::max(high, line.height(p));
    if (!(low < -tolerance && high > tolerance)) continue;
    lines.push_back(line);
    lines.back().is_edge = long_ > long_edge * size_of(piece.flat.ring);
  }
  PlanePoint middle;
  for (const PlaneTriangle& t : piece.triangles)
    for (const PlanePoint p : t) {
      const double weight = area_of(t) / (3 * piece.flat.area);
      middle.x += p.x * weight, middle.y += p.y * weight;
    }
  for (int i = 0; i < 8; ++i) {
    const double angle = std::numbers::pi / 8 * i, a = std::cos(angle), b = std::sin(angle);
    lines.push_back({a, b, a * middle.x + b * middle.y, false});
  }
  return lines;
}

/// What the hulls of the two sides measure, a little less for even halves along a long edge, and
/// a little more elsewhere; nothing where the line leaves one side empty. The hull of a side is
/// that of its outline and of where the line meets it.
std::optional<double> cost_of(std::span<const Edge> outline, const Line& line, double tolerance) {
  std::array<std::vector<PlanePoint>, 2> points;
  for (const Edge& e : outline) {
    const double a = line.height(e[0]), b = line.height(e[1]);
    if (std::min(a, b) < -tolerance) points[0].push_back(a < b ? e[0] : e[1]);
    if (std::max(a, b) > tolerance) points[1].push_back(a < b ? e[1] : e[0]);
    if (!(a * b < 0)) continue;
    const PlanePoint p = crossing(line, e[0], e[1]);
    points[0].push_back(p), points[1].push_back(p);
  }
  // An end on the line belongs to the sides that its edges go to.
  for (const Edge& e : outline)
    for (std::size_t i = 0; i < 2; ++i) {
      const double here = line.height(e[i]), there = line.height(e[1 - i]);
      if (std::abs(here) <= tolerance && std::abs(there) > tolerance)
        points[there > 0 ? 1 : 0].push_back(e[i]);
      else if (here * there > 0 && std::abs(here) > tolerance)
        points[here > 0 ? 1 : 0].push_back(e[i]);
    }
  const double right = area(planar_hull(std::move(points[0])));
  const double left = area(planar_hull(std::move(points[1])));
  if (!(right > 0) || !(left > 0)) return {};
  return right + left - (line.is_edge ? 1e-2 : -1e-2) * std::min(right, left);
}

/// Sets of triangles that hang together by corners.
std::vector<std::vector<PlaneTriangle>> components(std::span<const PlaneTriangle> triangles) {
  std::vector<std::pair<PlanePoint, std::uint32_t>> corners;
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    for (const PlanePoint p : triangles[i]) corners.emplace_back(p, i);
  std::sort(corners.begin(), corners.end(), [](const auto& a, const auto& b) {
    return a.first == b.first ? a.second < b.second : is_before(a.first, b.first);
  });
  detail::TriangleSets sets(triangles.size());
  for (std::size_t i = 1; i < corners.size(); ++i)
    if (corners[i].first == corners[i - 1].first)
      sets.join(corners[i].second, corners[i - 1].second);
  std::vector<std::size_t> set_of(triangles.size());
  std::vector<std::vector<PlaneTriangle>> result;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const std::uint32_t root = sets.find(i);  // the first of its set
    if (root == i) set_of[i] = result.size(), result.emplace_back();
    result[set_of[root]].push_back(triangles[i]);
  }
  return result;
}

/// Cuts pieces[index] in two or more, or marks it as done.
void split(std::vector<Piece>& pieces, std::size_t index, double tolerance) {
  Piece& piece = pieces[index];
  const std::vector<Edge> outline = outline_of(piece);
  std::optional<std::pair<double, Line>> best;
  if (!outline.empty())
    for (const Line& line : candidate_lines(piece, outline, tolerance))
      if (const std::optional<double> cost = cost_of(outline, line, tolerance))
        if (!best || *cost < best->first * (1 - 1e-9)) best = {*cost, line};
  if (!best) {
    piece.is_done = true;
    return;
  }
  const Sides sides = cut(piece.triangles, best->second, tolerance);
  std::vector<Piece> parts;
  for (const std::vector<PlaneTriangle>& side : sides) {
    std::vector<std::vector<PlaneTriangle>> sets = components(side);
    // Crumbs stay together.
    if (sets.size() + pieces.size() > 2 * most_cuts) sets = {side};
    for (std::vector<PlaneTriangle>& set : sets) parts.push_back(piece_of(std::move(set)));
  }
  pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(index));
  for (Piece& part : parts)
    if (part.flat.area > 0) pieces.push_back(std::move(part));
}

FlatPiece joined(const FlatPiece& a, const FlatPiece& b) {
  std::vector<PlanePoint> points = a.ring;
  points.insert(points.end(), b.ring.begin(), b.ring.end());
  return {thinned(planar_hull(std::move(points))), a.area + b.area};
}

double empty_part(const FlatPiece& piece) { return area(piece.ring) - piece.area; }

/// Joins pairs whose union is convex, and while there are too many those that leave least empty.
void join(std::vector<FlatPiece>& pieces, std::size_t most) {
  const auto growth = [&](std::size_t a, std::size_t b) {
    return empty_part(joined(pieces[a], pieces[b])) - empty_part(pieces[a]) - empty_part(pieces[b]);
  };
  std::vector<std::vector<double>> grows(pieces.size());  // [b][a] for a < b
  for (std::size_t b = 0; b < pieces.size(); ++b)
    for (std::size_t a = 0; a < b; ++a) grows[b].push_back(growth(a, b));
  while (pieces.size() > 1) {
    std::size_t best_a = 0, best_b = 1;
    for (std::size_t b = 1; b < pieces.size(); ++b)
      for (std::size_t a = 0; a < b; ++a)
        if (grows[b][a] < grows[best_b][best_a]) best_a = a, best_b = b;
    FlatPiece both = joined(pieces[best_a], pieces[best_b]);
    if (pieces.size() <= most && !is_convex(both)) return;
    pieces[best_a] = std::move(both);
    const auto gone = static_cast<std::ptrdiff_t>(best_b);
    pieces.erase(pieces.begin() + gone);
    grows.erase(grows.begin() + gone);
    for (std::size_t b = best_b; b < grows.size(); ++b) grows[b].erase(grows[b].begin() + gone);
    for (std::size_t a = 0; a < best_a; ++a) grows[best_a][a] = growth(a, best_a);
    for (std::size_t b = best_a + 1; b < pieces.size(); ++b) grows[b][best_a] = growth(best_a, b);
  }
}

}  // namespace

std::vector<FlatPiece> flat_pieces(std::span<const PlaneTriangle> triangles, std::size_t most) {
  std::vector<PlaneTriangle> sorted;
  for (PlaneTriangle t : triangles) {
    if (!(area_of(t) > 0)) continue;
    std::sort(t.begin(), t.end(), is_before);
    sorted.push_back(t);
  }
  if (sorted.empty()) return {};
  std::sort(sorted.begin(), sorted.end(), [](const PlaneTriangle& s, const PlaneTriangle& t) {
    return std::lexicographical_compare(s.begin(), s.end(), t.begin(), t.end(), is_before);
  });
  std::vector<Piece> pieces;
  pieces.push_back(piece_of(std::move(sorted)));
  const double tolerance = line_tolerance * size_of(pieces[0].flat.ring);
  for (std::size_t cuts = 0; cuts < std::min(most_cuts, 3 * (most - 1)); ++cuts) {
    const auto worst =
        std::max_element(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
          return (a.is_done ? 0 : a.empty) < (b.is_done ? 0 : b.empty);
        });
    if (worst->is_done) break;
    split(pieces, static_cast<std::size_t>(worst - pieces.begin()), tolerance);
  }
  std::vector<FlatPiece> result;
  for (Piece& piece : pieces) result.push_back(std::move(piece.flat));
  join(result, most);
  return result;
}

}  // namespace penumbra
