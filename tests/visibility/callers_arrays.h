// SPDX-License-Identifier: MIT
// Arrays of the kind that callers have.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "penumbra/geometry/vec.h"
#include "penumbra/visibility/rows.h"

namespace penumbra {

template <class Row>
Rows<Row> rows_of(const std::vector<Row>& rows) {
  return {rows.data(), rows.size()};
}

/// A vertex as renderers have it: positions are not alone.
struct Vertex {
  Vec3f position, normal;
  float uv[2];
};

/// A bumpy sheet, some spheres, a cone, a disk, and points on a floor below.
struct CallersArrays {
  std::vector<Vertex> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Vec3f> centers{{-2, 1, 0}, {0, 1.5f, 1}, {2, 1, -1}};
  std::vector<float> radii{0.5f, 0.25f, 0.75f};
  std::vector<Vec3f> bases{{-1, 0.5f, -2}}, apexes{{-1, 2, -2}}, disk_centers{{1, 2, 2}},
      disk_normals{{0, 2, 1}};
  std::vector<float> base_radii{0.5f}, apex_radii{0.125f}, disk_radii{0.75f};
  std::vector<Vec3f> points;
  std::vector<Vec3f> normals;
  std::vector<std::uint64_t> keys;

  CallersArrays() {
    constexpr std::uint32_t side = 8;
    for (std::uint32_t i = 0; i < side; ++i)
      for (std::uint32_t k = 0; k < side; ++k)
        vertices.push_back(
            {{0.3f * float(i) - 1, 2 + 0.1f * float(i * k % 3), 0.3f * float(k) - 1}, {}, {}});
    for (std::uint32_t i = 0; i + 1 < side; ++i)
      for (std::uint32_t k = 0; k + 1 < side; ++k) {
        const std::uint32_t at = i * side + k;
        triangles.push_back({at, at + 1, at + side});
        triangles.push_back({at + 1, at + side + 1, at + side});
      }
    for (int i = 0; i < 20; ++i)
      for (int k = 0; k < 20; ++k) {
        points.push_back({0.4f * float(i) - 4, 0, 0.4f * float(k) - 4});
        normals.push_back({0, 1, 0});
        keys.push_back(std::uint64_t(1000 * i + k));
      }
  }

  VectorRows positions() const { return {vertices.data(), vertices.size(), sizeof(Vertex)}; }
};

}  // namespace penumbra
