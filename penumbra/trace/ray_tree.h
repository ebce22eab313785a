// SPDX-License-Identifier: MIT
// The tree of rays behind one sample of a pixel (Whitted 1980): camera ray, reflections,
// refractions.
#pragma once

#include <cstdint>
#include <vector>

#include "penumbra/kernel/kernel.h"
#include "penumbra/scene/scene.h"
#include "penumbra/shadow/visibility.h"
#include "penumbra/trace/render.h"
#include "penumbra/trace/shading.h"

namespace penumbra {

/// What all rays of a picture share.
struct TraceContext {
  const Scene& scene;
  const ShadowScene& shadows;
  std::uint32_t depth;
};

/// What one thread owns while it works on a block of pixels.
struct TraceScratch {
  TraceScratch(std::uint32_t shadow_samples, std::size_t lights)
      : visibility(shadow_samples), cache(lights) {}
  VisibilityScratch visibility;
  OccluderCache cache;
  RenderCounters counters;
  double shadow_seconds = 0;
};

/// A node of the ray tree, for those who want to look inside (`explain_pixel`, layers of the
/// primary hit).
struct RayNode {
  std::uint64_t path;  ///< 1: camera ray; 2 path: reflected from there; 2 path + 1: refracted
  std::optional<Hit> hit;
  ShadingPoint point;             ///< where there is a hit
  std::vector<Visibility> light;  ///< of each light
  std::vector<Color> unshadowed;  ///< U of each light
};

/// Colour along a ray. `sample_key` identifies pixel and sample. Nodes are appended to `nodes` if
/// it is not null.
Color trace(const TraceContext& context, Vec3d origin, Vec3d direction, std::uint64_t sample_key,
            TraceScratch& scratch, std::vector<RayNode>* nodes);

}  // namespace penumbra
