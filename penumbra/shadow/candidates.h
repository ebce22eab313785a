// SPDX-License-Identifier: MIT
// Candidates: the records that may block a light as seen from some receivers, in the form that
// lanes sift.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "penumbra/kernel/record.h"

namespace penumbra {

/// Rows of numbers, one column a candidate of that kind. What is behind the last column is for
/// lanes to load and to mask; memory is not cleared.
template <ShapeKind kind, std::size_t numbers>
struct CandidateRows {
  static constexpr std::size_t most = 256, padded = most + 48;
  alignas(64) float row[numbers][padded];
  alignas(64) std::uint32_t index[padded];
  std::uint32_t count;
  void push(const float* column, std::uint32_t of) {
    for (std::size_t i = 0; i < numbers; ++i) row[i][count] = column[i];
    index[count++] = of;
  }
};

using SphereCandidates = CandidateRows<ShapeKind::sphere, 4>;
using RingCandidates = CandidateRows<ShapeKind::ring, 7>;
using ConeCandidates = CandidateRows<ShapeKind::cone, 9>;
using TriangleCandidates = CandidateRows<ShapeKind::triangle, 9>;

/// Up to `most` of each kind.
struct CandidateList {
  static constexpr std::size_t most = SphereCandidates::most;
  SphereCandidates spheres;      ///< centre 3, radius
  RingCandidates rings;          ///< centre 3, unit normal 3, radius
  ConeCandidates cones;          ///< base 3, unit axis 3, height, base radius, apex radius
  TriangleCandidates triangles;  ///< corners

  void clear() { spheres.count = rings.count = cones.count = triangles.count = 0; }
  std::size_t size() const { return spheres.count + rings.count + cones.count + triangles.count; }
  void add(const Record& record, std::uint32_t index) {
    const float* numbers = record.number.data();
    switch (record.kind) {
      case ShapeKind::sphere: return spheres.push(numbers, index);
      case ShapeKind::ring: return rings.push(numbers, index);
      case ShapeKind::cone: return cones.push(numbers, index);
      case ShapeKind::triangle: return triangles.push(numbers, index);
    }
  }
};

}  // namespace penumbra
