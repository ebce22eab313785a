// SPDX-License-Identifier: MIT
// One light as receivers see it: what all their questions begin with.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "penumbra/geometry/box.h"
#include "penumbra/geometry/light_sampling.h"
#include "penumbra/geometry/vec.h"
#include "penumbra/shadow/light_form.h"
#include "penumbra/shadow/shadow_query.h"

namespace penumbra {

/// A light as seen from one receiver p, or from all of a ball around p. Every sample lies within
/// `doubt` of p + way + (L - c), but for float's rounding of `way`, corners and size, which users
/// pad: 2^-20 of what they add up.
struct SeenLight {
  const LightForm* light = nullptr;
  bool counts_as_ball = false;  ///< the light's form is not to be looked at
  Vec3f p, normal;              ///< of the receiver
  Vec3f way;                    ///< c - p
  float distance = 0;           ///< its length
  float size = 0;               ///< the largest |l - c|
  float doubt = 0;              ///< by which samples may lie off the light
  float receiver_radius = 0;    ///< of the ball around p
  /// What lies below this height over p, along the normal, blocks no active sample; 0 for a single
  /// receiver.
  float floor = 0;
};

/// Up to 64 receivers and how they see a light, one array a number.
struct ReceiverRows {
  static constexpr std::size_t most = 64, padded = most + 16;
  alignas(64) float p[3][padded], normal[3][padded], way[3][padded];
  alignas(64) float distance[padded], doubt[padded];
  std::size_t count = 0;
};

/// How receivers see a light, a bit for each.
struct ReceiverBits {
  /// All numbers are finite and in range, p in the scene and surely outside the light. Of others
  /// nothing is known.
  std::uint64_t certain = 0;
  /// The same, but that p lies in the ball around the light, or next to it.
  std::uint64_t near = 0;
  /// Every sample lies above, or every sample below, the plane through p across the normal: proven,
  /// however it is rounded. Without a normal all are above.
  std::uint64_t above = 0, below = 0;
};

/// Fills the rows with the queries (at most 64), in their order. Cost: 3 ns a receiver.
ReceiverBits see_light(const LightForm& light, std::span<const ShadowQuery> queries,
                       const Box& scene, ReceiverRows& rows);

/// Keeps the rows of the set bits, in their order.
void keep_rows(std::uint64_t bits, ReceiverRows& rows);

/// A part of the rows; the light's samples are above each receiver's plane if `are_above`.
struct ReceiverGroup {
  const ReceiverRows& rows;
  std::size_t first, count;
  bool are_above;
  Box bounds() const;
};

SeenLight seen_by_one(const LightForm& light, const ReceiverRows& rows, std::size_t index);

/// From the receiver of `sight`, as if the light were no more than these of its samples (bits of a
/// word of 32, at least one).
SeenLight seen_part(const SeenLight& sight, const LightSamples& samples, std::uint32_t word,
                    std::uint32_t bits);

/// Whether the light lies apart from the ball of its receivers: that those at its corners are
/// outside the light does not say so of others.
bool is_apart(const SeenLight& seen);

/// From all of a group: the light counts as the ball around it.
SeenLight seen_by_all(const LightForm& light, const ReceiverGroup& group);

}  // namespace penumbra
