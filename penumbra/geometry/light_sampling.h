// SPDX-License-Identifier: MIT
// Points of a light, uniform in the solid angle it subtends at a receiver point.
// Ball and sun: cone of directions with 1 - cos = s²/(1 + cos), so that tiny and far lights keep
// their width in float. Rectangle: Urena, Fajardo, King 2013. Other parallelograms, polygons and
// meshes: spherical triangles (Arvo 1995). Disk: a spherical ellipse (after Guillén et al. 2017).
// Where the solid angle is too small for these (or p lies in the light's plane): by area. Lines:
// uniform in the angle they subtend.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "penumbra/geometry/light_shape.h"
#include "penumbra/geometry/sample_pattern.h"
#include "penumbra/geometry/triangle_sampling.h"
#include "penumbra/geometry/vec.h"

namespace penumbra {

/// The rays from one receiver point to its d samples, one array a coordinate so that lanes can load
/// them. Ray i is origin + t (x[i], y[i], z[i]) for 0 < t < t_max. The arrays are padded to a
/// multiple of `padding` with copies of the last sample.
struct LightSamples {
  static constexpr std::uint32_t padding = 16;
  Vec3f origin;
  float t_max = 1;             ///< 1, so that the ray ends at the sample; infinite for suns
  std::uint32_t count = 0;     ///< d
  std::vector<float> x, y, z;  ///< sample minus origin (for suns a unit direction)
  std::vector<SampledTriangle> scratch;  ///< of polygons and meshes, so that its memory is reused

  void resize(std::uint32_t d);
};

/// Fills `out` (reused between calls, so that nothing is allocated a ray) with the pattern's points
/// for this key. Point lights give `size()` equal samples. p inside a ball or mesh: uniform over
/// all directions, the sample on its surface. Samples lie within 8 ulp of (|p| + distance + size of
/// the light) of the light, on the side of a ball or mesh that p sees. Cost of d = 32 with AVX-512:
/// 0.11 microseconds for balls and suns, 0.4 for rectangles, 1 for lines, 2.6 for skew
/// parallelograms, disks and triangles, 3 to 6 for polygons and meshes of some 24 triangles.
void sample_light(const LightShape& light, Vec3f p, const SamplePattern& pattern, std::uint64_t key,
                  LightSamples& out);

}  // namespace penumbra
