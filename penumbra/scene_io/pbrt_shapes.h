// SPDX-License-Identifier: MIT
// pbrt's shapes, placed.
#pragma once

#include <cstdint>

#include "penumbra/scene_io/pbrt_lights.h"
#include "penumbra/scene_io/pbrt_scene.h"

namespace penumbra {

/// Shape, in the current transformation and of the current material. Throws Error for kinds that
/// pbrt-v4 does not have.
void add_pbrt_shape(PbrtScene& pbrt, const PbrtDefinition& definition);

// The parts of it, one file each; `params` are the shape's.

/// Sphere, cylinder and disk, whole or in part: as ours where the map leaves them such, else as
/// meshes.
void add_pbrt_sphere(PbrtScene& pbrt, const PbrtParams& params);
void add_pbrt_cylinder(PbrtScene& pbrt, const PbrtParams& params);
void add_pbrt_disk(PbrtScene& pbrt, const PbrtParams& params);

void add_pbrt_triangles(PbrtScene& pbrt, const PbrtParams& params);
void add_pbrt_ply(PbrtScene& pbrt, const PbrtParams& params);
void add_pbrt_loop(PbrtScene& pbrt, const PbrtParams& params);
void add_pbrt_patches(PbrtScene& pbrt, const PbrtParams& params);  ///< bilinearmesh

/// Bezier and B-spline curves: chains of cones.
void add_pbrt_curve(PbrtScene& pbrt, const PbrtParams& params);

/// Whether a mesh's triangles stand in a file, or are made from few numbers.
enum class PbrtMeshOrigin { file, made };

/// Places a mesh, in the shape's own frame and seen from outside, with its material. Throws Error
/// where the scene grows too large. `lights`: how many it is to pbrt where it glows; 0: each
/// triangle is one.
void add_pbrt_mesh(PbrtScene& pbrt, Mesh mesh, PbrtMeshOrigin origin, PbrtPlace place,
                   std::size_t lights = 0);

/// Counts so many vertices and triangles that few numbers of a file make; throws Error where there
/// are too many.
void charge_made(PbrtScene& pbrt, std::size_t cost, PbrtPlace place);

/// Material of a shape in the current state that glows so.
std::uint32_t pbrt_surface(PbrtScene& pbrt, const std::optional<PbrtGlow>& glow, bool casts_shadow);

/// Segments of a full turn that a mesh is given: fewer for lights, and where there are many.
int pbrt_segments(const PbrtScene& pbrt);

}  // namespace penumbra
