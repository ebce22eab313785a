// SPDX-License-Identifier: MIT
// What a method prepares of a scene before the first question.
#pragma once

#include <cstddef>
#include <memory>
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
  /// Of meshes, never null; empty unless the method is `shaft`. Shared with scenes that differ in
  /// their lights alone.
  std::shared_ptr<const TriangleSheet> sheet = std::make_shared<TriangleSheet>();

  /// Of what is prepared here beside the kernel: Table 3's shadow set.
  std::size_t memory_bytes() const {
    return set.memory_bytes() + inner.memory_bytes() + sheet->memory_bytes();
  }
};

/// `shapes` and `options` are those that the kernel was built from. Cost: O(n log n).
ShadowScene prepare_shadows(const Kernel& kernel, const ShapeSet& shapes,
                            const KernelOptions& options, std::span<const LightShape> lights,
                            Method method);

/// After the shapes of a scene that was prepared for `shaft` have moved: the same for the kernel
/// that was refitted to them, without lights. Neighbours are not looked for anew where they are
/// neighbours still.
ShadowScene with_moved_shapes(const ShadowScene& prepared, const Kernel& kernel,
                              const ShapeSet& shapes);

/// The same for one other light, by `shaft`, `stochastic` or `hard`, and for receivers in a box
/// that may reach out of the scene. `prepared` must be so for `shaft`, to be asked by it. Cost:
/// microseconds, linear in the light's corners.
ShadowScene with_light(const ShadowScene& prepared, const LightShape& light, Method method,
                       const Box& receivers);

}  // namespace penumbra
