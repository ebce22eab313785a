// SPDX-License-Identifier: MIT
// Middles of convex sets, for the centres of lights that are given by their corners.
#pragma once

#include <span>

#include "penumbra/geometry/mesh.h"
#include "penumbra/geometry/vec.h"

namespace penumbra {

/// Of the area of a convex polygon; the mean of its corners where it has none. Zero without
/// corners.
Vec3f area_centroid(std::span<const Vec3f> corners);

/// Of the volume inside a closed surface; the mean of its corners where it has none.
Vec3f volume_centroid(std::span<const Vec3f> corners, std::span<const Triangle> triangles);

/// Six times the volume inside a closed surface, positive where its triangles look outwards.
double six_volumes(std::span<const Vec3f> corners, std::span<const Triangle> triangles);

}  // namespace penumbra
