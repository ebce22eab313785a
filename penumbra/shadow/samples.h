// SPDX-License-Identifier: MIT
// The samples of one (point, light): taken, weighed, summed. What all methods share.
#pragma once

#include <cstdint>

#include "penumbra/shadow/visibility.h"

namespace penumbra {

/// Directions to the light's samples, their weights, and `active` where they lie above the horizon;
/// returns the number of these.
std::uint32_t take_samples(const ShadowScene& scene, std::uint32_t light, const Receiver& receiver,
                           std::uint64_t key, VisibilityScratch& scratch);

/// The visible part, given `blocked`; sums run in sample order. Without class.
Visibility sum_up(const VisibilityScratch& scratch);

/// All samples are sure to be above the horizon, in float too, however they will be rounded.
bool is_surely_above(const LightHull& light, const Receiver& receiver);

}  // namespace penumbra
