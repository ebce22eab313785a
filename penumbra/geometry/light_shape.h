// SPDX-License-Identifier: MIT
// The closed set of light shapes: compact convex sets with a centre (paper, section 2).
// To add one: a struct here, its place in LightShape, and an overload of each function below.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "penumbra/geometry/box.h"
#include "penumbra/geometry/vec.h"

namespace penumbra {

/// No size: its shadows are hard.
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

/// All points of a plane within `radius` (> 0) of the centre. Shines both ways.
struct DiskLight {
  Vec3f center, normal{0, 0, 1};  ///< the normal is unit
  float radius = 1;
};

/// The segment from center - half to center + half, a row of points that shine in all directions:
/// it has no area and subtends no solid angle. half is not 0.
struct LineLight {
  Vec3f center, half;
};

/// A convex polygon with its corners in order around it, planar to what float can say. The centre
/// lies in it. Shines both ways.
struct PolygonLight {
  Vec3f center;
  std::vector<Vec3f> corners;
};

/// The convex hull of its corners: a solid that shines outwards. The triangles are its closed
/// surface, counter-clockwise seen from outside. The centre lies inside.
struct MeshLight {
  Vec3f center;
  std::vector<Vec3f> corners;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// A cone of directions: infinitely far, the same from every point.
struct SunLight {
  Vec3f direction{0, 0, 1};         ///< unit, from the scene towards the sun
  float half_angle_rad = 0.00465f;  ///< half its angular diameter, in [0, pi/2)
};

/// Any of them.
using LightShape = std::variant<PointLight, BallLight, ParallelogramLight, DiskLight, LineLight,
                                PolygonLight, MeshLight, SunLight>;

/// Whether all of its samples are the same: points, and suns without size.
bool is_point(const LightShape& light);

/// The point the light shrinks to. Not for suns, which have none: their `direction` takes its
/// place.
std::optional<Vec3f> center(const LightShape& light);

/// Direction (unnormalised; unit for suns) from p towards the light's centre.
Vec3f towards_center(const LightShape& light, Vec3f p);

/// Farthest point of the light along `direction`: dot(support, direction) >= dot(l, direction) for
/// every l of the light, in double. Empty for suns.
std::optional<Vec3d> support(const LightShape& light, Vec3d direction);

/// Box that surely holds the light (a flat one where the light is flat along an axis); empty
/// optional for suns.
std::optional<Box> bounds(const LightShape& light);

/// True where p lies in the closed light, or so near its surface that float cannot tell. Never for
/// points and suns. NaN gives true (the side on which nothing is proven).
bool contains(const LightShape& light, Vec3f p);

/// Solid angle in steradians that the light subtends at p; 0 for points and lines, 4 pi inside a
/// ball or a mesh, 2 pi on a flat light. Cost: linear in the corners and triangles.
double solid_angle(const LightShape& light, Vec3f p);

/// The points whose convex hull is the light: of points, lines, parallelograms, polygons (in order
/// around them) and meshes. Empty for balls, disks and suns, which have none.
std::vector<Vec3d> corners(const LightShape& light);

}  // namespace penumbra
