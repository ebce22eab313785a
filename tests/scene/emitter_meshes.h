// SPDX-License-Identifier: MIT
// Things that glow, for tests.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numbers>
#include <vector>

#include "penumbra/geometry/polygon.h"
#include "penumbra/scene/scene.h"

namespace penumbra {

inline constexpr double pi = std::numbers::pi;

/// A scene of one mesh that glows.
inline Scene glowing(Mesh mesh, Color emission = {1, 2, 3}, bool is_two_sided = false) {
  Scene scene;
  scene.materials.emplace_back();
  scene.materials[0].emission = emission;
  scene.materials[0].emits_from_back = is_two_sided;
  scene.shapes.meshes.push_back(std::move(mesh));
  return scene;
}

inline void append(Mesh& to, const Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(to.positions.size());
  to.positions.insert(to.positions.end(), mesh.positions.begin(), mesh.positions.end());
  for (const Triangle& t : mesh.triangles)
    to.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

/// Cut into triangles; counter-clockwise.
inline Mesh polygon_mesh(std::vector<Vec3f> corners) {
  Mesh mesh;
  mesh.triangles = triangulate(corners);
  mesh.positions = std::move(corners);
  return mesh;
}

/// In the plane z = 0, looking up.
inline Mesh rectangle(float x, float y, float width, float height) {
  return polygon_mesh(
      {{x, y, 0}, {x + width, y, 0}, {x + width, y + height, 0}, {x, y + height, 0}});
}

inline Mesh regular_polygon(int corners, float radius = 1) {
  std::vector<Vec3f> ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * pi * i / corners;
    ring.emplace_back(radius * static_cast<float>(std::cos(angle)),
                      radius * static_cast<float>(std::sin(angle)), 0.0f);
  }
  return polygon_mesh(ring);
}

inline Mesh letter_l() {
  return polygon_mesh({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}});
}

inline Mesh letter_e() {
  return polygon_mesh({{0, 0, 0},
                       {3, 0, 0},
                       {3, 1, 0},
                       {1, 1, 0},
                       {1, 2, 0},
                       {2, 2, 0},
                       {2, 3, 0},
                       {1, 3, 0},
                       {1, 4, 0},
                       {3, 4, 0},
                       {3, 5, 0},
                       {0, 5, 0}});
}

/// A ring of quadrangles between two outlines.
inline Mesh flat_ring(int corners, float inner, float outer) {
  const Mesh a = regular_polygon(corners, inner), b = regular_polygon(corners, outer);
  Mesh mesh;
  append(mesh, a), append(mesh, b);
  mesh.triangles.clear();
  const auto n = static_cast<std::uint32_t>(corners);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    mesh.triangles.push_back({i, n + i, n + j});
    mesh.triangles.push_back({i, n + j, j});
  }
  return mesh;
}

enum class Closing { none, round, both };

/// A grid over (u, v) in [0, 1]², closed where said; triangles look along du x dv. Degenerate ones
/// are left out.
inline Mesh grid(int columns, int rows, Closing closing,
                 const std::function<Vec3d(double, double)>& at) {
  Mesh mesh;
  const auto index = [&](int column, int row) {
    if (closing != Closing::none) column %= columns;
    if (closing == Closing::both) row %= rows;
    return static_cast<std::uint32_t>(row * (columns + 1) + column);
  };
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column <= columns; ++column)
      mesh.positions.emplace_back(
          Vec3f(at(static_cast<double>(column) / columns, static_cast<double>(row) / rows)));
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Vec3f p = mesh.positions[a], q = mesh.positions[b], r = mesh.positions[c];
    if (p != q && q != r && r != p) mesh.triangles.push_back({a, b, c});
  };
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const std::uint32_t a = index(column, row), b = index(column + 1, row),
                          c = index(column + 1, row + 1), d = index(column, row + 1);
      add(a, b, c), add(a, c, d);
    }
  return mesh;
}

inline Mesh ball_mesh(int columns, int rows, double radius = 1, double part = 1) {
  return grid(columns, rows, Closing::round, [=](double u, double v) {
    const double longitude = 2 * pi * u, latitude = pi * (v * part + (1 - part) - 0.5);
    // Poles are one point each, to the bit.
    const double ring = v * part + (1 - part) == 0 || v == 1 ? 0 : std::cos(latitude);
    return Vec3d(std::cos(longitude) * ring, std::sin(longitude) * ring, std::sin(latitude)) *
           radius;
  });
}

inline Mesh torus_mesh(int columns, int rows, double radius, double thickness) {
  return grid(columns, rows, Closing::both, [=](double u, double v) {
    const double around = 2 * pi * u, about = 2 * pi * v;
    const double ring = radius + thickness * std::cos(about);
    return Vec3d(std::cos(around) * ring, std::sin(around) * ring, thickness * std::sin(about));
  });
}

inline Mesh open_cylinder(int columns, double radius, double height) {
  return grid(columns, 1, Closing::round, [=](double u, double v) {
    return Vec3d(std::cos(2 * pi * u) * radius, std::sin(2 * pi * u) * radius, v * height);
  });
}

/// A prism over a polygon of the plane z = 0: closed, looking outwards.
inline Mesh prism(const Mesh& base, float height) {
  Mesh mesh = base;
  const auto n = static_cast<std::uint32_t>(base.positions.size());
  for (Vec3f p : base.positions) mesh.positions.push_back(p + Vec3f{0, 0, height});
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  for (const Triangle& t : base.triangles) mesh.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    mesh.triangles.push_back({i, j, j + n});
    mesh.triangles.push_back({i, j + n, i + n});
  }
  return mesh;
}

inline Mesh box_mesh(float width, float depth, float height) {
  return prism(rectangle(0, 0, width, depth), height);
}

inline Mesh moved(Mesh mesh, Vec3f by) {
  for (Vec3f& p : mesh.positions) p = p + by;
  return mesh;
}

}  // namespace penumbra
