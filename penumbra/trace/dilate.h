// SPDX-License-Identifier: MIT
// Filling what lies around the charts of a texture, so that filtering finds no hole.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace penumbra {

inline constexpr std::uint32_t no_texel = 0xffffffffu;

/// For each texel of a width x height texture (fewer than 2^32 - 1 texels) where its value comes
/// from: itself where it is covered (not 0), else the nearest covered one, if that is at most
/// `padding` texels away, from middle to middle, else `no_texel`. Of several that are as near
/// always the same. Cost: linear in texels, times the padding for those far from any that is
/// covered.
std::vector<std::uint32_t> nearest_covered(std::span<const std::uint8_t> covered,
                                           std::uint32_t width, std::uint32_t height,
                                           std::uint32_t padding);

}  // namespace penumbra
