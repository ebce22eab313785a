// SPDX-License-Identifier: MIT
// Radiance's glowing surfaces and sources as lights, and the exposure of it all.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "penumbra/scene/scene.h"
#include "penumbra/scene_io/radiance_materials.h"
#include "penumbra/scene_io/radiance_shapes.h"
#include "penumbra/scene_io/source.h"

namespace penumbra {

/// What a scene's lights are gathered in, in world coordinates.
struct RadianceLights {
  Mesh glowing;  ///< polygons and faceted shapes whose materials have emission, for the emitters
  std::vector<std::pair<std::uint32_t, Color>> seen;  ///< materials' radiance that lights nothing
  std::optional<Color> sky_above, sky_below;  ///< radiance of the halves of the surroundings
};

/// A light of the shape alone, shining from its front: balls, disks and convex polygons; nothing
/// for others. A spotlight's cone goes along `spot_direction` (in the world).
std::optional<Light> light_of(const RadianceShape& shape, const RadianceLook& look,
                              Vec3d spot_direction);

/// A `source`: direction and angle in degrees. Lights of less than half of all directions are suns,
/// other sources sky.
void add_source(Scene& scene, RadianceLights& lights, const RadianceLook& look, Vec3d direction,
                double angle_deg);

/// Makes lights of what glows, and brings radiance to what a picture shows: lights as
/// `balance_lights` does it, what is seen and the sky by the same factor.
void finish_lights(Scene& scene, RadianceLights lights, Warnings& warnings);

}  // namespace penumbra
