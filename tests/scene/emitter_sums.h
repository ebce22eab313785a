// SPDX-License-Identifier: MIT
// What glowing triangles give by themselves, and what the lights in their place give.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "penumbra/geometry/irradiance.h"
#include "penumbra/geometry/projected_solid_angle.h"
#include "penumbra/geometry/reduced_hull.h"
#include "penumbra/geometry/transform.h"
#include "penumbra/scene/emitters.h"
#include "penumbra/scene/scene.h"

namespace penumbra {

struct Receiver {
  Vec3f p, n;
};

/// All triangles of a scene that glow, in the world.
template <typename Visit>
void visit_glowing(const Scene& scene, const Visit& visit) {
  const auto visit_meshes = [&](const std::vector<Mesh>& meshes, const Transform& placement) {
    for (const Mesh& mesh : meshes) {
      const Mesh placed = transformed(mesh, placement);
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Material& material = scene.materials[surface_of(mesh, t)];
        if (max_abs(material.emission) == 0) continue;
        const Triangle& corner = placed.triangles[t];
        visit(std::array<Vec3f, 3>{placed.positions[corner[0]], placed.positions[corner[1]],
                                   placed.positions[corner[2]]},
              material);
      }
    }
  };
  visit_meshes(scene.shapes.meshes, {});
  for (const Instance& i : scene.shapes.instances)
    visit_meshes(scene.shapes.groups[i.group].meshes, i.placement);
}

/// Unshadowed, each triangle in closed form (Lambert), green.
inline double irradiance_of_triangles(const Scene& scene, const Receiver& at) {
  double sum = 0;
  visit_glowing(scene, [&](const std::array<Vec3f, 3>& t, const Material& material) {
    const Vec3d p(at.p);
    const std::array<Vec3d, 3> seen{Vec3d(t[0]) - p, Vec3d(t[1]) - p, Vec3d(t[2]) - p};
    const double side = dot(seen[0], cross(seen[1] - seen[0], seen[2] - seen[0]));
    if (side >= 0 && !material.emits_from_back) return;
    sum += static_cast<double>(material.emission.y) * projected_solid_angle(seen, Vec3d(at.n));
  });
  return sum;
}

/// The same of lights.
inline double irradiance_of_lights(const std::vector<Light>& lights, const Receiver& at) {
  double sum = 0;
  for (const Light& light : lights) {
    if (light.beam && !(dot(light.beam->axis, towards_center(light.shape, at.p)) < 0)) continue;
    sum += static_cast<double>(light.intensity.y) * irradiance(light.shape, at.p, at.n) *
           inverse_square_factor(light.shape, at.p);
  }
  return sum;
}

/// Over pi, green, of triangles of which one side counts.
inline double power_of_triangles(const Scene& scene) {
  double sum = 0;
  visit_glowing(scene, [&](const std::array<Vec3f, 3>& t, const Material& material) {
    const double area = 0.5 * length(cross(Vec3d(t[1]) - Vec3d(t[0]), Vec3d(t[2]) - Vec3d(t[0])));
    sum += static_cast<double>(material.emission.y) * area;
  });
  return sum;
}

inline bool is_flat(const LightShape& shape) {
  return std::holds_alternative<ParallelogramLight>(shape) ||
         std::holds_alternative<PolygonLight>(shape) || std::holds_alternative<DiskLight>(shape);
}

/// Flat shapes give half of pi times their intensity in the mean over all directions.
inline double power_of_lights(const std::vector<Light>& lights) {
  double sum = 0;
  for (const Light& light : lights)
    sum += static_cast<double>(light.intensity.y) * (is_flat(light.shape) ? 2 : 4) *
           (light.beam ? 0.5 : 1);
  return sum;
}

inline Box glowing_box(const Scene& scene) {
  Box box;
  visit_glowing(scene, [&](const std::array<Vec3f, 3>& t, const Material&) {
    for (const Vec3f p : t) box.add(p);
  });
  return box;
}

/// Around the scene, from near it (a fifth of its size) to five times its size away, turned any way
/// that faces its middle.
inline std::vector<Receiver> receivers_around(const Scene& scene, std::size_t count) {
  const Box box = glowing_box(scene);
  const double size = length(Vec3d(box.hi) - Vec3d(box.lo));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Receiver> receivers;
  for (const Vec3d direction : spread_directions(count)) {
    const double distance = size * (0.7 + 5 * std::pow(unit(random), 3));
    const Vec3d p = Vec3d(box.center()) + direction * distance;
    Vec3d n = normalize(Vec3d(unit(random) - 0.5, unit(random) - 0.5, unit(random) - 0.5));
    if (dot(n, direction) > 0) n = -n;
    receivers.push_back({Vec3f(p), Vec3f(n)});
  }
  return receivers;
}

/// Errors of the lights' irradiance, over the mean of what is right.
struct SumErrors {
  double most = 0, mean = 0;
};

inline SumErrors errors_of(const Scene& lit, std::size_t count = 200) {
  SumErrors errors;
  double sum = 0, wrong = 0, most = 0;
  for (const Receiver& at : receivers_around(lit, count)) {
    const double right = irradiance_of_triangles(lit, at);
    const double is = irradiance_of_lights(lit.lights, at);
    const double scale = length_squared(Vec3d(at.p) - Vec3d(glowing_box(lit).center()));
    sum += right * scale;
    wrong += std::abs(is - right) * scale;
    most = std::max(most, std::abs(is - right) * scale);
  }
  errors.mean = wrong / sum;
  errors.most = most * static_cast<double>(count) / sum;
  return errors;
}

/// How far triangles stick out of the lights' hulls together, over the size of all: the largest of
/// many directions.
inline double uncovered(const Scene& lit) {
  const Box box = glowing_box(lit);
  double worst = 0;
  for (const Vec3d direction : spread_directions(200)) {
    double wanted = -1e30, is = -1e30;
    visit_glowing(lit, [&](const std::array<Vec3f, 3>& t, const Material&) {
      for (const Vec3f p : t) wanted = std::max(wanted, dot(Vec3d(p), direction));
    });
    for (const Light& light : lit.lights)
      is = std::max(is, dot(*support(light.shape, direction), direction));
    worst = std::max(worst, wanted - is);
  }
  return worst / length(Vec3d(box.hi) - Vec3d(box.lo));
}

}  // namespace penumbra
