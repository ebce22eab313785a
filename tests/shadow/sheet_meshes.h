// SPDX-License-Identifier: MIT
// Meshes that a light may be hidden behind, whole and broken, for the tests of sheets.
#pragma once

#include <cmath>

#include "tests/shadow/nasty_meshes.h"

namespace penumbra::nasty {

/// A cloth of n x n quads over [-1, 1]², flat, in waves, or rolled so that it lies over itself.
inline Mesh cloth(std::uint32_t n, double waves, double roll, Random& random) {
  Mesh mesh;
  const double noise = random.one_in(2) ? 0 : double(random.power(-4, -1)) / n;
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t k = 0; k <= n; ++k) {
      const double u = 2.0 * i / n - 1, v = 2.0 * k / n - 1;
      const double z = waves * std::sin(4 * u + 1) * std::cos(3 * v);
      const Vec3d flat{u + roll * std::sin(3 * u), v, z + roll * std::cos(3 * u)};
      mesh.positions.push_back(Vec3f(flat + Vec3d(random.in_cube()) * noise));
    }
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t a = i * (n + 1) + k, b = a + 1, c = b + n + 1, d = a + n + 1;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  return mesh;
}

inline std::uint32_t any_triangle(const Mesh& mesh, Random& random) {
  return random.below(static_cast<std::uint32_t>(mesh.triangles.size()));
}

/// One triangle is missing, turned, there twice, has a fin on an edge, or spans what it should not.
inline void damage(Mesh& mesh, Random& random) {
  if (mesh.triangles.empty()) return;
  Triangle& one = mesh.triangles[any_triangle(mesh, random)];
  switch (random.below(6)) {
    case 0: mesh.triangles.erase(mesh.triangles.begin() + any_triangle(mesh, random)); break;
    case 1: std::swap(one[0], one[1]); break;
    case 2: mesh.triangles.push_back(Triangle(one)); break;
    case 3: {
      const auto tip = static_cast<std::uint32_t>(mesh.positions.size());
      mesh.positions.push_back(mesh.positions[one[2]] + random.in_cube());
      mesh.triangles.push_back({one[0], one[1], tip});
      break;
    }
    case 4: one[random.below(3)] = mesh.triangles[any_triangle(mesh, random)][0]; break;
    case 5: mesh.positions[one[0]] = mesh.positions[one[0]] + random.in_cube() * 0.3f; break;
  }
}

/// Every triangle gets corners of its own, as STL has them.
inline Mesh unwelded(const Mesh& mesh) {
  Mesh result;
  for (const Triangle& t : mesh.triangles) {
    const auto n = static_cast<std::uint32_t>(result.positions.size());
    for (const std::uint32_t corner : t) result.positions.push_back(mesh.positions[corner]);
    result.triangles.push_back({n, n + 1, n + 2});
  }
  return result;
}

inline Mesh random_sheet(Random& random) {
  const float bump = random.one_in(2) ? 0 : random.uniform(0, 0.6f);
  const std::uint32_t n = 1 + random.below(16);
  switch (random.below(6)) {
    case 0: return random_mesh(random);
    case 1: return solid_meshes::globe(6 + random.below(18), double(bump));
    case 2: return solid_meshes::globe(4 + random.below(10), double(bump), 1 + random.below(6));
    case 3: return cloth(n, 0, 0, random);
    case 4: return cloth(n, double(random.power(-3, 0)), 0, random);
    default: return cloth(4 + n, double(random.power(-3, 0)), double(random.power(-1, 0)), random);
  }
}

/// One or two of them in one mesh or in several, some with clear triangles (surface 1).
inline ShapeSet random_sheets(const Place& place, Random& random) {
  ShapeSet shapes;
  Mesh mesh = random_sheet(random);
  if (random.one_in(3))
    mesh = solid_meshes::joined(
        mesh, solid_meshes::placed(random.one_in(2) ? mesh : random_sheet(random),
                                   random.one_in(3) ? 1 : random.uniform(0.5f, 2),
                                   random.in_cube() * (random.one_in(3) ? 0 : 0.3f)));
  for (std::uint32_t i = random.below(6); i > 3; --i) damage(mesh, random);
  if (random.one_in(4)) mesh = unwelded(mesh);
  const Vec3f x = random.one_in(2) ? Vec3f{1, 0, 0} : random.in_cube();
  const Vec3f y = random.one_in(2) ? Vec3f{0, 1, 0} : random.in_cube();
  const Vec3f z = random.one_in(2) ? Vec3f{0, 0, 1} : random.in_cube();
  for (Vec3f& p : mesh.positions) p = place(x * p.x + y * p.y + z * p.z);
  drop_degenerate_triangles(mesh);
  if (random.one_in(4))
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      mesh.surfaces.push_back(random.one_in(40) ? 1 : 0);
  if (!mesh.triangles.empty()) shapes.meshes.push_back(mesh);
  if (random.one_in(6)) shapes.spheres.push_back({place({0, 0, 0}), place.scale, 0});
  return shapes;
}

}  // namespace penumbra::nasty
