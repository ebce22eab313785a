// SPDX-License-Identifier: MIT
// What of a renderer's scene blocks light.
#pragma once

#include "penumbra/scene/scene.h"
#include "penumbra/visibility/occluders.h"

namespace penumbra {

/// The shapes of a validated scene but those whose material casts no shadow, committed: asked by
/// the renderer's points and keys they give its answers. Geometries: spheres, cones (open ones,
/// then capped ones), rings, meshes, of each kind those that there are; groups and instances as in
/// the scene. Takes a copy of the shapes, and keeps it.
Occluders occluders_of(const Scene& scene);

}  // namespace penumbra
