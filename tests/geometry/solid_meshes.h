// SPDX-License-Identifier: MIT
// Meshes with and without an inside, for the tests of solids.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "penumbra/geometry/mesh.h"
#include "penumbra/geometry/transform.h"

namespace penumbra::solid_meshes {

inline Mesh placed(const Mesh& mesh, float scale, Vec3f offset) {
  Mesh result = mesh;
  for (Vec3f& p : result.positions) p = p * scale + offset;
  return result;
}

inline Mesh joined(Mesh a, const Mesh& b) {
  const auto first = static_cast<std::uint32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const Triangle& t : b.triangles)
    a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return a;
}

/// From (-1, -1, -1) to (1, 1, 1); vertex i has the bits of i as coordinates. The last two
/// triangles are the side at x = 1.
inline Mesh box() {
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.push_back({i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f, i & 4 ? 1.0f : -1.0f});
  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  quad(0, 2, 3, 1), quad(4, 5, 7, 6), quad(0, 1, 5, 4);
  quad(2, 6, 7, 3), quad(0, 4, 6, 2), quad(1, 3, 7, 5);
  return mesh;
}

/// A grid of rows x columns quads that closes on itself both ways; the torus has radii 2 and 0.7.
template <typename Place>
Mesh wrapped(std::uint32_t rows, std::uint32_t columns, Place place) {
  Mesh mesh;
  for (std::uint32_t r = 0; r < rows; ++r)
    for (std::uint32_t c = 0; c < columns; ++c)
      mesh.positions.push_back(
          Vec3f(place(2 * std::numbers::pi * r / rows, 2 * std::numbers::pi * c / columns)));
  for (std::uint32_t r = 0; r < rows; ++r)
    for (std::uint32_t c = 0; c < columns; ++c) {
      const std::uint32_t a = r * columns + c, b = r * columns + (c + 1) % columns;
      const std::uint32_t d = (r + 1) % rows * columns;
      mesh.triangles.push_back({a, b, d + b % columns});
      mesh.triangles.push_back({a, d + b % columns, d + c});
    }
  return mesh;
}
inline Mesh torus(std::uint32_t rows, std::uint32_t columns) {
  return wrapped(rows, columns, [](double u, double v) {
    const double ring = 2 + 0.7 * std::cos(v);
    return Vec3d(ring * std::cos(u), ring * std::sin(u), 0.7 * std::sin(v));
  });
}
/// Crosses itself along a curve: its section is a figure of eight.
inline Mesh crossed_torus(std::uint32_t rows, std::uint32_t columns) {
  return wrapped(rows, columns, [](double u, double v) {
    const double ring = 3 + std::sin(v);
    return Vec3d(ring * std::cos(u), ring * std::sin(u), 0.8 * std::sin(2 * v));
  });
}

/// Unit ball with its poles on z, bumpy by `bump`; `turns` other than 1 leave a slice open.
inline Mesh globe(std::uint32_t rows, double bump = 0, std::uint32_t missing_columns = 0) {
  Mesh mesh;
  const std::uint32_t columns = 2 * rows;
  for (std::uint32_t r = 0; r <= rows; ++r)
    for (std::uint32_t c = 0; c < columns; ++c) {
      const double polar = std::numbers::pi * r / rows, around = std::numbers::pi * c / rows;
      const double ring = r == 0 || r == rows ? 0 : std::sin(polar);
      const double size = 1 + bump * std::sin(5 * polar) * ring * std::cos(4 * around);
      mesh.positions.push_back(
          Vec3f(Vec3d(ring * std::cos(around), ring * std::sin(around), std::cos(polar)) * size));
    }
  for (std::uint32_t r = 0; r < rows; ++r)
    for (std::uint32_t c = 0; c + missing_columns < columns; ++c) {
      const std::uint32_t a = r * columns + c, b = r * columns + (c + 1) % columns;
      if (r > 0) mesh.triangles.push_back({a, b + columns, b});
      if (r + 1 < rows) mesh.triangles.push_back({a, a + columns, b + columns});
    }
  return mesh;
}

inline Mesh moebius_strip(std::uint32_t columns) {
  Mesh mesh;
  for (std::uint32_t c = 0; c < columns; ++c)
    for (const double side : {-0.4, 0.4}) {
      const double u = 2 * std::numbers::pi * c / columns;
      const double ring = 1 + side * std::cos(u / 2);
      mesh.positions.push_back(
          Vec3f(Vec3d(ring * std::cos(u), ring * std::sin(u), side * std::sin(u / 2))));
    }
  for (std::uint32_t c = 0; c < columns; ++c) {
    const std::uint32_t a = 2 * c, b = 2 * c + 1;
    const bool is_last = c + 1 == columns;
    const std::uint32_t next_a = is_last ? 1 : a + 2, next_b = is_last ? 0 : b + 2;
    mesh.triangles.push_back({a, next_a, next_b});
    mesh.triangles.push_back({a, next_b, b});
  }
  return mesh;
}

/// An L of three unit cubes, extruded: not convex.
inline Mesh corner_piece() {
  Mesh mesh;
  const float xy[6][2] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  for (const float z : {0.0f, 1.0f})
    for (const auto& p : xy) mesh.positions.push_back({p[0], p[1], z});
  const Triangle bottom[4] = {{0, 2, 1}, {0, 3, 2}, {0, 4, 3}, {0, 5, 4}};
  for (const Triangle& t : bottom) {
    mesh.triangles.push_back(t);
    mesh.triangles.push_back({t[0] + 6, t[2] + 6, t[1] + 6});
  }
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t j = (i + 1) % 6;
    mesh.triangles.push_back({i, j, j + 6});
    mesh.triangles.push_back({i, j + 6, i + 6});
  }
  return mesh;
}

}  // namespace penumbra::solid_meshes
