// SPDX-License-Identifier: MIT
// Points of polygon and mesh lights, uniform in solid angle.
#pragma once

#include <vector>

#include "penumbra/geometry/light_shape.h"
#include "penumbra/geometry/sample_loops.h"
#include "penumbra/geometry/seen_triangles.h"
#include "penumbra/geometry/spherical_triangle.h"

namespace penumbra {

/// One triangle of a light and its share of the samples.
struct SampledTriangle {
  SeenTriangle seen;
  double solid_angle = 0;
  double share_end = 0;   ///< those of all triangles up to this one, added up: not scaled to 1
  bool is_ready = false;  ///< what follows is computed; only for triangles that are chosen
  SphericalTriangle sphere;
  Vec3d normal, for_second, for_third;  ///< give the weights of the edges in a point of its plane
};

/// Replaces (u, v) by samples minus p. u chooses among the triangles of the fan around the first
/// corner, by their solid angles, and then runs along the side opposite it, on the next triangle's
/// from where it ended; v goes from the first corner to that side. By area where p sees the light
/// edge-on or too small. `scratch` keeps its memory between calls.
void sample_polygon(const PolygonLight& light, Vec3f p, SampleArrays samples,
                    std::vector<SampledTriangle>& scratch);

/// The same on the triangles that face p; on all of them for p inside.
void sample_mesh(const MeshLight& light, Vec3f p, SampleArrays samples,
                 std::vector<SampledTriangle>& scratch);

}  // namespace penumbra
