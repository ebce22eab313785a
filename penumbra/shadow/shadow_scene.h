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
#include "penumbra/shadow/shadow_set.h"
#include "penumbra/shadow/sheet.h"

namespace penumbra {

/// The paper's methods (a) to (e):
/// hard: one ray to the light's centre;
/// stochastic: d rays for every point and light, the judge of all others;
/// offset: rays only where the shadow set says so;
/// reduced: the same with offsets reduced by t_max;
/// umbra: reduced, plus inner offsets, for solids, flat shapes and meshes;
/// and beyond it
/// shaft: one query of the geometry set for a tile of receivers; no second set.
/// All but hard give the same visibility, bit for bit.
enum class Method { hard, stochastic, offset, reduced, umbra, shaft };

/// True for methods that prove lit points by a shadow set.
constexpr bool has_shadow_set(Method method) {
  return method == Method::offset || method == Method::reduced || method == Method::umbra;
}

/// True for methods that prove points lit or in umbra, without samples.
constexpr bool proves(Method method) { return has_shadow_set(method) || method == Method::shaft; }

/// How the paper's methods trace the samples of a point: in packets, or one ray after the other
/// with the cache of the paper asked for each (sections 2 and 5), as tracers of its time did. Same
/// answers, other counters and times. `shaft` knows packets alone.
enum class RayGrouping { packets, single };

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
