// SPDX-License-Identifier: MIT
// One primitive in the form that rays are tested against: 48 bytes, the same for every kind.
#pragma once

#include <array>
#include <cstdint>

#include "penumbra/geometry/shape.h"

namespace penumbra {

/// Numbers by kind (world space):
///   - sphere: centre 3, radius
///   - cone: base 3, unit axis 3, height, base radius, apex radius, slope (the radii's difference
///     by the height)
///   - ring: centre 3, unit normal 3, radius, inner radius
///   - triangle: corners 9
struct Record {
  std::array<float, 10> number{};
  std::uint32_t id = 0;  ///< position in `all_primitives`; those of instances go on behind it
  ShapeKind kind = ShapeKind::sphere;
  bool is_capped = false;
  bool casts_shadow = true;
  std::uint8_t unused = 0;

  Vec3f vector(int first) const { return {number[first], number[first + 1], number[first + 2]}; }
};
static_assert(sizeof(Record) == 48);

Record make_record(const ShapeSet& shapes, ShapeRef ref, std::uint32_t id);

/// Box of the record's shape, rounded outward. A function of the record alone: hierarchy and
/// intersector must agree on it (see intersect-inl.h).
Box bounds(const Record& record);

}  // namespace penumbra
