// SPDX-License-Identifier: MIT
// A light in float, as lanes of receivers see it.
#pragma once

#include <array>
#include <cstdint>

#include "penumbra/shadow/light_hull.h"

namespace penumbra {

/// Prepared once a light: a centre, and around it a ball, a disk or the hull of corners. Lights of
/// more than 16 corners count as the ball around them.
struct LightForm {
  explicit LightForm(const LightHull& light);

  enum class Form : std::uint8_t { ball, disk, corners } form = Form::ball;
  bool is_sun = false;
  std::uint8_t corner_count = 0;
  Vec3f center, center_rest;       ///< c is their sum; for suns c - p
  float size = 0;                  ///< the largest |l - c|, rounded up
  Vec3f axis{};                    ///< of the disk, unit
  std::array<Vec3f, 16> corner{};  ///< minus c
};

}  // namespace penumbra
