// SPDX-License-Identifier: MIT
// Inner offsets: occluders that hide a whole light (paper, section 3, Lemma 3, Eq. 8).
//
// With x(s) = p + s (c - p), the shaft's cross-section at s is x(s) + s (L - c). Where it lies in a
// convex solid Q, each segment from p to a point of L passes through Q, so that it leaves Q before
// it ends outside: blocked. That x(s) lies in the inner offset of Q by s (L ⊖ c) is the same
// statement; the paper takes t_max for every s, which proves less. What Q hides from p is convex,
// so that for lights with corners each corner's segment may pass Q at an s of its own.
#pragma once

#include "penumbra/kernel/record.h"
#include "penumbra/shadow/light_hull.h"

namespace penumbra {

/// True only if every sample of the light is blocked by the record alone, as seen from p: proven,
/// with the errors of samples and intersector.
///   (1) Spheres, capped cones and cylinders: the light is outside the solid and each segment to it
///   passes through; p may be inside. Exact but for (6); ball lights lose 2 % of their radius where
///   they are hidden between cap and side.
///   (2) Open cones and cylinders: besides, the shaft misses one of the missing caps for p outside
///   the solid, both for p inside. Cones flatter than 1 : 4 never cover.
///   (3) Triangles: exact but for (6).
///   (4) Rings: besides, the shaft misses the hole. Ball lights lose 2 % of their radius.
///   (5) Never: records that cast no shadow; lights not surely outside; NaN and numbers so large or
///   small that float's range may fail.
///   (6) Everything must hold by 64 ulp (see intersect-inl.h), flat shapes and open ends by 128, so
///   that what is smaller than that beside its distance from p covers nothing.
/// Cost: linear in the light's corners where the ball around the light is not hidden; 10-150 ns for
/// most that don't cover, 80-650 ns where proven.
bool surely_covers(const Record& record, const LightHull& light, Vec3f p);

/// Whether every segment from p to a sample passes the ball more than `margin` deep before it ends.
/// The ball may be a part of any solid that the light is surely outside of: such a segment leaves
/// the solid, and is blocked. Exact for ball lights and those with corners; suns and disks lose up
/// to 2 % of their radius.
bool ball_covers(Vec3d center, double radius, const LightHull& light, Vec3f p, double margin);

}  // namespace penumbra
