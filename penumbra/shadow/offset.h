// SPDX-License-Identifier: MIT
// Outer offsets: occluders grown by what the light requires (paper, section 2, Definition 1-2,
// Lemma 1, Eq. 1-4). A sample that Q blocks is blocked at some q = p + s (l - p), and then
// p + s (c - p) lies in Q ⊖ s (L ⊖ c): where the segment from p to the centre misses
// Q ⊖ t (L ⊖ c) for a t not below every such s, Q blocks no sample.
#pragma once

#include "penumbra/kernel/record.h"
#include "penumbra/shadow/light_hull.h"

namespace penumbra {

/// True only if no sample of the light is blocked by the record, as seen from p, given that blocked
/// ones would be blocked at s <= t: proven, with the intersector's errors. Solids stand for their
/// surfaces. Exact to rounding for every pair of shape and light, but for a ring's hole, in which
/// the light's extent along the ring's plane is taken as that of a ball around c. False in doubt
/// (NaN).
bool surely_misses_offset(const Record& record, const LightHull& light, Vec3f p, double t);

/// True only if a plane on p's side of the record proves that it blocks no sample: p and the whole
/// light lie on one side of a triangle's or ring's plane, or above the plane that touches a sphere
/// or (closed) cone where it is nearest to p, or of a cap or the side next to p. Settles the
/// surface that p lies on. Part of `surely_misses_offset`.
bool surely_behind_horizon(const Record& record, const LightHull& light, Vec3f p);

/// Box that holds Q ⊖ t (L ⊖ c), given a box of Q; padded by more than all that
/// `surely_misses_offset` pads for any p in the receivers' box: where the segment from such a p to
/// the centre misses it, Q blocks no sample at s <= t.
Box offset_bounds(const Box& occluder, const LightHull& light, double t, const Box& receivers);

}  // namespace penumbra
