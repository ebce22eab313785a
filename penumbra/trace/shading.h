// SPDX-License-Identifier: MIT
// What a surface makes of the light that arrives: U of the rule colour = U x V, where V is the
// visible fraction.
#pragma once

#include "penumbra/geometry/surface_point.h"
#include "penumbra/scene/scene.h"

namespace penumbra {

/// A hit with all that shading needs.
struct ShadingPoint {
  SurfacePoint surface;
  Vec3f receiver;        ///< p', where shadow and reflected rays start
  Vec3f normal;          ///< unit, geometric, towards the viewer
  Vec3f shading_normal;  ///< unit, interpolated where the mesh has normals; on the side of `normal`
  Vec3f to_viewer;       ///< unit
  const Material* material = nullptr;
  Color diffuse;  ///< of the material, times texture and vertex colour
};

ShadingPoint shading_point(const Scene& scene, ShapeRef shape, Vec3d origin, Vec3d direction,
                           double t);

/// Light of the surface's own, towards the viewer: what shines from its front alone is dark from
/// behind.
Color emitted(const ShadingPoint& point);

/// Light reflected towards the viewer if the whole light were visible. It does not depend on d:
/// Lambert in closed form (see irradiance.h), Phong's highlight by the light's centre. Where
/// normals are interpolated it goes smoothly to 0 as the light's centre nears the geometric horizon
/// (Chiang, Li, Burley: Taming the Shadow Terminator, 2019), so that facets of a coarse mesh don't
/// show; visibility knows nothing of it. The light's beam counts.
Color unshadowed(const Light& light, const ShadingPoint& point);

/// Directions of secondary rays; not normalised.
Vec3f mirrored_direction(const ShadingPoint& point);

/// Snell's law; nothing where the light is totally reflected.
std::optional<Vec3f> refracted_direction(const ShadingPoint& point);

}  // namespace penumbra
