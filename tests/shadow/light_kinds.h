// SPDX-License-Identifier: MIT
// The eight kinds of light, each of one centre and about one size, regular or at random: the one
// maker of lights for all tests of shadows.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "penumbra/geometry/light_shape.h"
#include "tests/kernel/nasty_shapes.h"

namespace penumbra {

inline constexpr std::array light_kinds = {"point", "ball",    "parallelogram", "disk",
                                           "line",  "polygon", "mesh",          "sun"};

/// Solids over a polygon: with an apex on each side, with one, or with a copy of it.
enum class LightSolid { bipyramid, pyramid, prism };

/// What is left of a light without its place, kind and size.
struct LightFigure {
  Vec3d u, v, w;               ///< half axes of a light of size 1; |u| = 1, u and v span flat ones
  std::vector<double> angles;  ///< of corners around w, radians; no gap as wide as pi
  LightSolid solid = LightSolid::bipyramid;
};

/// Faces along `way`: polygons have five corners, meshes seven.
inline LightFigure facing_figure(Vec3d way) {
  const Frame<double> frame = frame_around(normalize(way));
  LightFigure form{frame.u, frame.v * 0.7 + frame.u * 0.2, frame.n, {}};
  for (int k = 0; k < 5; ++k) form.angles.push_back(0.4 * std::numbers::pi * k);
  return form;
}

/// Turned, squeezed and skewed, with 3 to 10 corners around it (meshes: 4 to 20).
inline LightFigure random_figure(nasty::Random& random) {
  LightFigure form;
  form.u = random.direction();
  form.v = normalize(cross(form.u, random.direction() + Vec3d{0.1, 0.2, 0.3}));
  form.w = cross(form.u, form.v) * double(random.uniform(0.05f, 1));
  form.v = form.v * double(random.uniform(0.05f, 1));
  if (random.one_in(2)) form.v = form.v + form.u * 0.5;
  if (random.one_in(2)) form.w = form.w + form.u * 0.5;
  const std::uint32_t count = 3 + random.below(8);
  const float jitter = random.one_in(2) ? 0 : 0.45f;
  for (std::uint32_t i = 0; i < count; ++i)
    form.angles.push_back(2 * std::numbers::pi * double(float(i) + random.uniform(0, jitter)) /
                          count);
  form.solid = static_cast<LightSolid>(random.below(3));
  return form;
}

inline MeshLight mesh_light(const LightFigure& form, Vec3d center, double size) {
  MeshLight mesh{Vec3f(center), {}, {}};
  const auto n = static_cast<std::uint32_t>(form.angles.size());
  const auto add_corner = [&](Vec3d from_center) {
    mesh.corners.push_back(Vec3f(center + from_center * size));
  };
  const auto add_ring = [&](double height) {
    for (const double angle : form.angles)
      add_corner(form.u * std::cos(angle) + form.v * std::sin(angle) + form.w * height);
  };
  add_ring(form.solid == LightSolid::bipyramid ? 0 : -0.5);
  if (form.solid == LightSolid::prism) {
    add_ring(0.5);
  } else {
    add_corner(form.w);
    if (form.solid == LightSolid::bipyramid) add_corner(-form.w);
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    if (form.solid == LightSolid::prism) {
      mesh.triangles.push_back({i, next, next + n});
      mesh.triangles.push_back({i, next + n, i + n});
    } else {
      mesh.triangles.push_back({i, next, n});
    }
    if (form.solid == LightSolid::bipyramid) {
      mesh.triangles.push_back({next, i, n + 1});
    } else if (i > 0 && next > 0) {
      mesh.triangles.push_back({0, next, i});
      if (form.solid == LightSolid::prism) mesh.triangles.push_back({n, i + n, next + n});
    }
  }
  // A skewed frame may look the other way round.
  if (dot(cross(form.u, form.v), form.w) < 0)
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

/// `size` is the radius: how far the light reaches along u. A sun is as wide as something of that
/// size at the centre, seen from `seen_from`.
inline LightShape make_light(std::string_view kind, const LightFigure& form, Vec3d center,
                             double size, Vec3f seen_from) {
  const Vec3f c(center), u(form.u * size), v(form.v * size);
  if (kind == "point") return PointLight{c};
  if (kind == "ball") return BallLight{c, float(size)};
  if (kind == "parallelogram") return ParallelogramLight{c, u, v};
  if (kind == "disk") return DiskLight{c, Vec3f(normalize(cross(form.u, form.v))), float(size)};
  if (kind == "line") return LineLight{c, u};
  if (kind == "polygon") {
    PolygonLight polygon{c, {}};
    for (const double angle : form.angles)
      polygon.corners.push_back(
          Vec3f(center + (form.u * std::cos(angle) + form.v * std::sin(angle)) * size));
    return polygon;
  }
  if (kind == "mesh") return mesh_light(form, center, size);
  const Vec3d way = center - Vec3d(seen_from);
  const Vec3d direction = way == Vec3d{} ? Vec3d{0, 0, 1} : normalize(way);
  return SunLight{Vec3f(direction), float(std::min(1.5, std::atan2(size, length(way))))};
}

/// Regular; flat lights face `target`, and a sun shines towards it.
inline LightShape light_of_kind(std::string_view kind, Vec3f center, float size, Vec3f target) {
  return make_light(kind, facing_figure(Vec3d(target) - Vec3d(center)), Vec3d(center), double(size),
                    target);
}

}  // namespace penumbra
