// SPDX-License-Identifier: MIT
// Private to the layer: the ground and the lights that a bare model is given.
#pragma once

#include <vector>

#include "penumbra/scene/framing.h"
#include "penumbra/scene/light.h"

namespace penumbra::detail {

/// Light from everywhere and the colour behind everything, where a file gives none.
constexpr Color studio_ambient{0.16f, 0.16f, 0.17f};
constexpr Color studio_background{0.62f, 0.68f, 0.76f};
constexpr Color studio_ground{0.52f, 0.52f, 0.51f};

/// A large square across `up` at this height along it, two triangles, centred under the subject and
/// wide enough to look endless.
Mesh ground(const Subject& subject, Vec3d up, double height, std::uint32_t surface);

/// A large ball light from the upper left, seen from `eye`, and a small one from the right.
/// Together with the ambient light they leave white just below full. For an eye among the objects
/// (a room), both hang under the ceiling.
std::vector<Light> studio_lights(const Subject& subject, Vec3d up, Vec3d eye);

}  // namespace penumbra::detail
