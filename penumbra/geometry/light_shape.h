// SPDX-License-Identifier: MIT
// The closed set of light shapes: compact convex sets with a centre (paper, section 2).
// To add one: a struct here, its place in LightShape, and an overload of each function below.
#pragma once

#include <optional>
#include <variant>

#include "penumbra/geometry/box.h"
#include "penumbra/geometry/vec.h"

namespace penumbra {

struct PointLight {
  Vec3f center;
};

/// Solid ball; radius > 0.
struct BallLight {
  Vec3f center;
  float radius = 1;
};

/// center + a u + b v with a, b in [-1, 1]: u and v are half edges, not parallel. Shines both ways.
struct ParallelogramLight {
  Vec3f center, u, v;
};

/// A cone of directions: infinitely far, the same from every point.
struct SunLight {
  Vec3f direction{0, 0, 1};         ///< unit, from the scene towards the sun
  float half_angle_rad = 0.00465f;  ///< half its angular diameter, in [0, pi/2)
};

using LightShape = std::variant<PointLight, BallLight, ParallelogramLight, SunLight>;

/// The point the light shrinks to. Not for suns, which have none: their `direction` takes its
/// place.
std::optional<Vec3f> center(const LightShape& light);

/// Direction (unnormalised; unit for suns) from p towards the light's centre.
Vec3f towards_center(const LightShape& light, Vec3f p);

/// Farthest point of the light along `direction`: dot(support, direction) >= dot(l, direction) for
/// every l of the light, in double. Empty for suns.
std::optional<Vec3d> support(const LightShape& light, Vec3d direction);

/// Box that surely holds the light; empty optional for suns.
std::optional<Box> bounds(const LightShape& light);

/// True where p lies in the closed light, or so near its surface that float cannot tell. Never for
/// points and suns. NaN gives true (the side on which nothing is proven).
bool contains(const LightShape& light, Vec3f p);

/// Solid angle in steradians that the light subtends at p; 0 for points, 4 pi inside a ball.
double solid_angle(const LightShape& light, Vec3f p);

}  // namespace penumbra
