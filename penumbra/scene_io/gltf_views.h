// SPDX-License-Identifier: MIT
// glTF's cameras and punctual lights.
#pragma once

#include <optional>

#include "penumbra/geometry/transform.h"
#include "penumbra/scene/scene.h"
#include "penumbra/scene_io/gltf_document.h"

namespace penumbra {

/// A camera of the list, placed; nothing, with a warning, where its numbers make no picture. It
/// looks along its -z; scales do not count. An aspect ratio becomes the picture's size, 512 high.
std::optional<Camera> read_camera(const GltfDocument& gltf, std::size_t index,
                                  const Transform& world, Warnings& warnings);

/// A light of KHR_lights_punctual that hangs on `node`, in candela (points, spots) and lux (suns);
/// nothing where it is dark, and with a warning where its type is not known.
/// (1) Points and spots are balls where the extras of the light, or of the node, name a radius
/// above 0 in metres: `radius`, `light_radius`, `lightRadius`, or Blender's `shadow_soft_size`.
/// (2) Spots shine along their -z, fully within the inner angle and not at all outside the outer.
/// (3) Directional lights are suns, 0.53 degrees wide unless extras name an angular diameter in
/// radians, as glTF gives all angles: `angle` (Blender's) or `angular_diameter`.
std::optional<Light> read_light(const GltfDocument& gltf, std::size_t index, const Json& node,
                                const Transform& world, Warnings& warnings);

}  // namespace penumbra
