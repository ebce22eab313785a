// SPDX-License-Identifier: MIT
#include "penumbra/scene/surface_nets.h"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>

namespace penumbra::detail {

namespace {

using Field = double (*)(Vec3d);
using Cell = std::array<std::size_t, 3>;

/// The field's values at all grid points, x fastest.
struct Samples {
  const GridPlanes& planes;
  std::vector<float> values;

  std::size_t size(int axis) const { return planes[axis].size(); }
  std::size_t index(Cell c) const { return (c[2] * size(1) + c[1]) * size(0) + c[0]; }
  Vec3d point(Cell c) const { return {planes[0][c[0]], planes[1][c[1]], planes[2][c[2]]}; }
  float at(Cell c) const { return values[index(c)]; }
};

/// Calls back with every cell's low corner, from the `first`-th cell along each axis on.
template <std::invocable<Cell> Visit>
void for_each_cell(const Samples& samples, std::size_t first, Visit&& visit) {
  for (std::size_t z = first; z + 1 < samples.size(2); ++z)
    for (std::size_t y = first; y + 1 < samples.size(1); ++y)
      for (std::size_t x = first; x + 1 < samples.size(0); ++x) visit(Cell{x, y, z});
}

/// Fills blocks of points; those that the surface cannot reach get the value of their middle.
void fill(Samples& samples, Field field, double steepness) {
  constexpr std::size_t block = 4;
  Cell low{}, high{};
  const auto fill_block = [&] {
    const Vec3d a = samples.point(low), b = samples.point({high[0] - 1, high[1] - 1, high[2] - 1});
    const double middle = field((a + b) * 0.5);
    const bool is_far = std::abs(middle) > steepness * length(b - a) * 0.5;
    for (std::size_t z = low[2]; z < high[2]; ++z)
      for (std::size_t y = low[1]; y < high[1]; ++y)
        for (std::size_t x = low[0]; x < high[0]; ++x) {
          const Cell c{x, y, z};
          samples.values[samples.index(c)] =
              static_cast<float>(is_far ? middle : field(samples.point(c)));
        }
  };
  for (low[2] = 0; low[2] < samples.size(2); low[2] += block)
    for (low[1] = 0; low[1] < samples.size(1); low[1] += block)
      for (low[0] = 0; low[0] < samples.size(0); low[0] += block) {
        for (int axis = 0; axis < 3; ++axis)
          high[axis] = std::min(low[axis] + block, samples.size(axis));
        fill_block();
      }
}

/// Corner `bits` of a cell: bit i says whether it is at the cell's upper end along axis i.
Cell corner_of(Cell c, int bits) {
  for (int axis = 0; axis < 3; ++axis) c[axis] += (bits >> axis) & 1;
  return c;
}

/// Which corners of a cell are inside, as bits.
unsigned signs(const Samples& samples, Cell c) {
  unsigned inside = 0;
  for (int bits = 0; bits < 8; ++bits)
    inside |= static_cast<unsigned>(samples.at(corner_of(c, bits)) < 0) << bits;
  return inside;
}

/// An outer corner between inner ones that touch only across a face's diagonal, or across the
/// cell's: there two sheets of the surface would share an edge or a vertex.
std::optional<int> pinched_corner(unsigned inside) {
  const auto is_inside = [&](int bits) { return ((inside >> bits) & 1) != 0; };
  for (int axis = 0; axis < 3; ++axis) {
    const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
    for (int side : {0, 1 << axis})
      if (is_inside(side) == is_inside(side | u | v) &&
          is_inside(side | u) == is_inside(side | v) && is_inside(side) != is_inside(side | u))
        return is_inside(side) ? side | u : side;
  }
  for (int bits = 0; bits < 4; ++bits) {
    const unsigned diagonal = 1u << bits | 1u << (7 - bits);
    if (inside == diagonal) return bits ^ 1;
    if (inside == (0xffu & ~diagonal)) return bits;
  }
  return std::nullopt;
}

/// Takes such corners in until there are none. Ends, since points only ever go inside.
void part_sheets(Samples& samples) {
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for_each_cell(samples, 0, [&](Cell c) {
      const unsigned inside = signs(samples, c);
      if (inside == 0 || inside == 0xff) return;
      const std::optional<int> corner = pinched_corner(inside);
      if (!corner) return;
      samples.values[samples.index(corner_of(c, *corner))] = -std::numeric_limits<float>::epsilon();
      has_changed = true;
    });
  }
}

/// Differences along the corners of a small tetrahedron, which need four values instead of six.
Vec3d gradient(Field field, Vec3d p) {
  constexpr double step = 1e-3;
  constexpr std::array<Vec3d, 4> corners{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}};
  Vec3d sum;
  for (Vec3d corner : corners) sum += corner * field(p + corner * step);
  return sum / (4 * step);
}

/// Mean of the points where the surface crosses the cell's edges; nothing where it crosses none.
std::optional<Vec3d> crossing(const Samples& samples, Cell c) {
  Vec3d sum;
  int crossings = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (int corner = 0; corner < 4; ++corner) {
      Cell a = c;
      a[(axis + 1) % 3] += corner & 1;
      a[(axis + 2) % 3] += corner >> 1;
      Cell b = a;
      ++b[axis];
      const double fa = samples.at(a), fb = samples.at(b);
      if ((fa < 0) == (fb < 0)) continue;
      sum += samples.point(a) + (samples.point(b) - samples.point(a)) * (fa / (fa - fb));
      ++crossings;
    }
  if (crossings == 0) return std::nullopt;
  return sum / static_cast<double>(crossings);
}

/// The field's slope over a cell, from its corners.
Vec3d slope_of(const Samples& samples, Cell c) {
  const Vec3d size = samples.point(corner_of(c, 7)) - samples.point(c);
  Vec3d slope;
  for (int bits = 0; bits < 8; ++bits)
    for (int axis = 0; axis < 3; ++axis) {
      const double value = samples.at(corner_of(c, bits));
      slope[axis] += ((bits >> axis) & 1 ? value : -value) / (4 * size[axis]);
    }
  return slope;
}

/// Two steps towards the surface that stay in the cell, then the normal there.
void add_vertex(Mesh& mesh, const Samples& samples, Field field, Cell c, Vec3d p) {
  const Vec3d low = samples.point(c), high = samples.point(corner_of(c, 7));
  const Vec3d slope = slope_of(samples, c);
  const double steep = std::max(length_squared(slope), 0.1);
  for (int step = 0; step < 2; ++step) p = max(low, min(high, p - slope * (field(p) / steep)));
  mesh.positions.push_back(Vec3f(p));
  mesh.normals.push_back(Vec3f(normalize(gradient(field, p))));
}

/// The quadrilateral of the four cells around a grid edge, cut along its shorter diagonal.
void add_quad(Mesh& mesh, std::array<std::uint32_t, 4> v) {
  const auto distance = [&](int a, int b) {
    return length_squared(mesh.positions[v[a]] - mesh.positions[v[b]]);
  };
  if (distance(0, 2) <= distance(1, 3)) {
    mesh.triangles.push_back({v[0], v[1], v[2]});
    mesh.triangles.push_back({v[0], v[2], v[3]});
  } else {
    mesh.triangles.push_back({v[1], v[2], v[3]});
    mesh.triangles.push_back({v[1], v[3], v[0]});
  }
}

constexpr std::uint32_t no_vertex = std::numeric_limits<std::uint32_t>::max();

}  // namespace

Mesh surface_nets(const GridPlanes& planes, double (*field)(Vec3d), double steepness) {
  Samples samples{planes, {}};
  samples.values.resize(samples.size(0) * samples.size(1) * samples.size(2));
  fill(samples, field, steepness);
  part_sheets(samples);

  Mesh mesh;
  std::vector<std::uint32_t> vertex(samples.values.size(), no_vertex);  // by the cell's low corner
  for_each_cell(samples, 0, [&](Cell c) {
    const std::optional<Vec3d> mean = crossing(samples, c);
    if (!mean) return;
    vertex[samples.index(c)] = static_cast<std::uint32_t>(mesh.positions.size());
    add_vertex(mesh, samples, field, c, *mean);
  });
  for_each_cell(samples, 1, [&](Cell c) {
    for (int axis = 0; axis < 3; ++axis) {
      Cell next = c;
      ++next[axis];
      const bool is_inside = samples.at(c) < 0;
      if (is_inside == (samples.at(next) < 0)) continue;
      Cell u = c, v = c, uv = c;
      --u[(axis + 1) % 3], --uv[(axis + 1) % 3];
      --v[(axis + 2) % 3], --uv[(axis + 2) % 3];
      std::array<std::uint32_t, 4> around{vertex[samples.index(c)], vertex[samples.index(u)],
                                          vertex[samples.index(uv)], vertex[samples.index(v)]};
      if (!is_inside) std::swap(around[1], around[3]);
      add_quad(mesh, around);
    }
  });
  return mesh;
}

}  // namespace penumbra::detail
