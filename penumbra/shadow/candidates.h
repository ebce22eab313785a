// SPDX-License-Identifier: MIT
// Candidates: the records that may block a light as seen from some receivers, in the form that
// lanes sift for one receiver.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "penumbra/kernel/record.h"
#include "penumbra/shadow/light_hull.h"

namespace penumbra {

/// One array a number; all padded to whole groups of lanes. Balls are spheres, and balls around
/// cones and rings.
class CandidateList {
 public:
  static constexpr std::size_t lanes = 16;

  void clear();
  void add(const Record& record, std::uint32_t index);
  std::size_t size() const { return balls_ + triangles_; }

  /// Appends to `out` the records that the shaft from p to the light may meet: all but those of
  /// which float arithmetic, with room for its errors and the intersector's, shows that it misses
  /// them. Cost: some 50 operations for 16 candidates.
  void sift(const LightHull& light, Vec3f p, std::vector<std::uint32_t>& out) const;

 private:
  std::size_t balls_ = 0, triangles_ = 0;
  std::vector<float> ball_[4], triangle_[9];
  std::vector<std::uint32_t> ball_record_, triangle_record_;
};

}  // namespace penumbra
