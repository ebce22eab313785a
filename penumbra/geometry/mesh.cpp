// SPDX-License-Identifier: MIT
#include "penumbra/geometry/mesh.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace penumbra {
/// Anything not finite is no degenerate triangle: it stays for `validate` to complain about.
bool is_degenerate(const Mesh& mesh, const Triangle& t) {
  const Vec3f a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
  if (a == b || b == c || c == a) return true;
  const Vec3d ab = Vec3d(b) - Vec3d(a), ac = Vec3d(c) - Vec3d(a);
  constexpr double rounding = 2 * std::numeric_limits<double>::epsilon();
  return length(cross(ab, ac)) <= rounding * length(ab) * length(ac);
}

std::size_t drop_degenerate_triangles(Mesh& mesh) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (is_degenerate(mesh, mesh.triangles[i])) continue;
    mesh.triangles[kept] = mesh.triangles[i];
    if (!mesh.surfaces.empty()) mesh.surfaces[kept] = mesh.surfaces[i];
    ++kept;
  }
  const std::size_t dropped = mesh.triangles.size() - kept;
  mesh.triangles.resize(kept);
  if (!mesh.surfaces.empty()) mesh.surfaces.resize(kept);
  return dropped;
}

std::vector<std::uint32_t> welded_vertices(const Mesh& mesh) {
  // {bits of x, y, z, vertex}: unlike floats, bits are ordered even where a coordinate is NaN.
  // Adding 0 makes -0 and 0 one.
  std::vector<std::array<std::uint32_t, 4>> places;
  places.reserve(mesh.positions.size());
  const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x + 0.0f); };
  for (const Vec3f p : mesh.positions)
    places.push_back({bits(p.x), bits(p.y), bits(p.z), static_cast<std::uint32_t>(places.size())});
  std::sort(places.begin(), places.end());

  std::vector<std::uint32_t> first(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool repeats =
        i > 0 && std::equal(places[i].begin(), places[i].end() - 1, places[i - 1].begin());
    first[places[i][3]] = repeats ? first[places[i - 1][3]] : places[i][3];
  }
  return first;
}

double area(const Mesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3d a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
    sum += length(cross(b - a, c - a)) / 2;
  }
  return sum;
}

Box bounds(const Mesh& mesh) {
  Box box;
  for (const Triangle& triangle : mesh.triangles)
    for (std::uint32_t corner : triangle) box.add(mesh.positions[corner]);
  return box;
}

}  // namespace penumbra
