// SPDX-License-Identifier: MIT
// How far two pictures are apart.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "penumbra/scene/image.h"

namespace penumbra {

struct ImageDifference {
  double rmse = 0, psnr = std::numeric_limits<double>::infinity();  ///< peak 1, in dB
  double largest = 0;
  std::uint64_t pixels = 0;  ///< with a channel that differs
};

/// Of these channels of images of the same size that have all of them. Pixels differ when a channel
/// is more than `tolerance` apart; without one, when they are not the same bits (NaN is equal to
/// NaN).
ImageDifference difference(const Image& a, const Image& b, std::optional<double> tolerance,
                           const std::vector<std::string>& channels = {"R", "G", "B"});

}  // namespace penumbra
