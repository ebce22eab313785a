// SPDX-License-Identifier: MIT
// How far an offset may be reduced (paper, Lemma 2, Eq. 5-7).
#pragma once

#include "penumbra/geometry/box.h"
#include "penumbra/shadow/light_hull.h"

namespace penumbra {

/// Upper bound in [0, 1] of s = |q - p| / |l - p| over all l of the light, q of the occluder and
/// receiver points p with q on the segment from p to l: receivers in the box that lie in the
/// occluder's shadow. With p = q + v (q - l), v >= 0, it is v / (1 + v), and along any axis a the
/// farthest v follows from a . q, a . l and the least a . p (our form of Eq. 6); the least over
/// several axes counts. 1 where nothing bounds it. Receivers must hold every p' of the scene, so
/// that reflections are safe.
double t_max(const Box& occluder, const LightHull& light, const Box& receivers);

}  // namespace penumbra
