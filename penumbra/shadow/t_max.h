// SPDX-License-Identifier: MIT
// How far an offset may be reduced (paper, Lemma 2, Eq. 5-7).
#pragma once

#include "penumbra/geometry/box.h"
#include "penumbra/shadow/light_hull.h"

namespace penumbra {

/// Upper bound in [0, 1] of s = |q - p| / |l - p| over all samples l of the light, hits q of the
/// occluder and receiver points p in the box with q on the segment from p to l; errors of hits and
/// samples included. With p = q + v (q - l), v >= 0, it is v / (1 + v), and along any axis a on
/// which the occluder lies before the light the farthest v follows from the most a . q, the least
/// a . l and the least a . p (our form of Eq. 6). The three axes both ways and the one from
/// occluder to light are tried; then the receivers are clipped to what the shadow can reach, and
/// tried again. Suns: s is the distance along their direction over the hull's reach. 1 where
/// nothing bounds it (the light beside or in the box, an empty box, NaN); 0 where no receiver lies
/// in the shadow, so that the occluder blocks none. Receivers must hold every p' of the scene, so
/// that reflections are safe. Cost: some microseconds, nothing allocated.
double t_max(const Box& occluder, const LightHull& light, const Box& receivers);

}  // namespace penumbra
