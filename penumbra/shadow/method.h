// SPDX-License-Identifier: MIT
// The methods, by which a scene's questions of visibility are answered.
#pragma once

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

}  // namespace penumbra
