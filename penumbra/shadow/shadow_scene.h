// SPDX-License-Identifier: MIT
// What a method prepares of a scene before the first question.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "penumbra/geometry/light_shape.h"
#include "penumbra/kernel/kernel.h"
#include "penumbra/shadow/inner_volumes.h"
#include "penumbra/shadow/light_form.h"
#include "penumbra/shadow/light_hull.h"
#include "penumbra/shadow/method.h"
#include "penumbra/shadow/shadow_set.h"
#include "penumbra/shadow/sheet.h"

namespace penumbra {

/// Refers to the kernel, which must live as long.
struct ShadowScene {
  const Kernel* kernel = nullptr;
  Method method = Method::stochastic;
  RayGrouping rays = RayGrouping::packets;
  std::vector<LightShape> lights;
  std::vector<LightHull> hulls;  ///< of the lights
  std::vector<LightForm> forms;  ///< the same in float
  Box receivers;                 ///< holds p' of every surface; nothing is proven of other points
  ShadowSet set;                 ///< empty unless the method has one
  InnerVolumes inner;            ///< of meshes; empty unless the method is `umbra`
  TriangleSheet sheet;           ///< of meshes; empty unless the method is `shaft`

  /// Of what is prepared here beside the kernel: Table 3's shadow set.
  std::size_t memory_bytes() const {
    return set.memory_bytes() + inner.memory_bytes() + sheet.memory_bytes();
  }
};

/// `shapes` and `options` are those that the kernel was built from. Cost: O(n log n).
ShadowScene prepare_shadows(const Kernel& kernel, const ShapeSet& shapes,
                            const KernelOptions& options, std::span<const LightShape> lights,
                            Method method);

}  // namespace penumbra
