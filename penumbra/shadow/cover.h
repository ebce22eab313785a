// SPDX-License-Identifier: MIT
// Inner offsets: occluders that hide a whole light (paper, section 3, Lemma 3, Eq. 8).
//
// With x(s) = p + s (c - p), the shaft's cross-section at s is x(s) + s (L - c). Where it lies in a
// convex solid Q, each segment from p to a point of L passes through Q, so that it leaves Q before
// it ends outside: blocked. That x(s) lies in the inner offset of Q by s (L ⊖ c) is the same
// statement; the paper takes t_max for every s, which proves less.
#pragma once

#include "penumbra/kernel/record.h"
#include "penumbra/shadow/light_hull.h"

namespace penumbra {

/// True only if every sample of the light is blocked by the record alone, as seen from p: proven,
/// with the intersector's errors. Spheres, cones (capped; open ones where the shaft misses the
/// missing caps that matter), rings and triangles (as seen from p they cover the light). Never for
/// records that cast no shadow, nor where the light is not surely outside the solid.
bool surely_covers(const Record& record, const LightHull& light, Vec3f p);

/// Whether a cross-section of the shaft lies in the ball, which may be a part of any solid that the
/// light is surely outside of. `margin`: how deep inside, at least.
bool ball_covers(Vec3d center, double radius, const LightHull& light, Vec3f p, double margin);

}  // namespace penumbra
