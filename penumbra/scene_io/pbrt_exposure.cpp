// SPDX-License-Identifier: MIT
// A white surface shows I / distance² here and I / (pi distance²) there, so lights get 1 / pi of
// the factor that radiances get.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "penumbra/scene_io/exposure.h"
#include "penumbra/scene_io/pbrt_lights.h"

namespace penumbra {
namespace {

constexpr double pi = std::numbers::pi;

Color times(Color color, double factor) { return max(Color(Vec3d(color) * factor), Color{}); }

double largest(Color color) { return static_cast<double>(max_abs(color)); }

double strength(const std::vector<Light>& lights) {
  double sum = 0;
  for (const Light& light : lights) sum += largest(light.intensity);
  return sum;
}

/// What the film makes of radiance.
double film_factor(const PbrtScene& pbrt) {
  double factor = 1;
  if (pbrt.film) factor *= pbrt.film->params.number("iso", 100) / 100;
  if (pbrt.camera)
    factor *= pbrt.camera->params.number("shutterclose", 1) -
              pbrt.camera->params.number("shutteropen", 0);
  return factor > 0 && std::isfinite(factor) ? factor : 1;
}

/// Some points of what is lit: every so many vertices, and centres.
std::vector<Vec3f> some_points(const Scene& scene) {
  constexpr std::size_t a_kind = 4096;
  const auto glows = [&](std::uint32_t surface) {
    return largest(scene.materials[surface].emission) > 0;
  };
  std::vector<Vec3f> points;
  const auto add = [&](std::size_t count, const auto& at) {
    for (std::size_t i = 0; i < count; i += 1 + count / a_kind) points.push_back(at(i));
  };
  const ShapeSet& shapes = scene.shapes;
  for (const Sphere& sphere : shapes.spheres)
    if (!glows(sphere.surface)) points.push_back(sphere.center);
  for (const Ring& ring : shapes.rings)
    if (!glows(ring.surface)) points.push_back(ring.center);
  add(shapes.cones.size(), [&](std::size_t i) { return shapes.cones[i].base; });
  add(shapes.instances.size(), [&](std::size_t i) {
    const Instance& instance = shapes.instances[i];
    const Box box = bounds(shapes.groups[instance.group]);
    return Vec3f(apply_point(instance.placement, Vec3d(box.is_empty() ? Vec3f{} : box.center())));
  });
  std::size_t vertices = 0;
  for (const Mesh& mesh : shapes.meshes) vertices += mesh.positions.size();
  const std::size_t step = 1 + vertices / a_kind;
  for (const Mesh& mesh : shapes.meshes)
    if (mesh.triangles.size() > 0 && !glows(surface_of(mesh, 0)))
      for (std::size_t i = 0; i < mesh.positions.size(); i += step)
        points.push_back(mesh.positions[i]);
  return points;
}

/// What a white surface at p that faces all lights shows, lights alone. None counts as nearer than
/// `nearest`.
double shown(const std::vector<Light>& lights, Vec3f p, double nearest) {
  double sum = 0;
  for (const Light& light : lights) {
    const double square = length_squared(Vec3d(towards_center(light.shape, p)));
    const bool fades = light.falloff == Falloff::inverse_square;
    sum += largest(light.intensity) / pi / (fades ? std::max(square, nearest * nearest) : 1);
  }
  return sum;
}

/// The factor of radiances: the film's, unless nine in ten points are then black, or blinding;
/// else that of `balance_lights`.
double exposure_of(PbrtScene& pbrt, Color around) {
  constexpr double black = 1.0 / 50, blinding = 50;
  const double film = film_factor(pbrt);
  std::vector<Light>& lights = pbrt.scene.lights;
  const double nearest =
      std::max(static_cast<double>(bounds(pbrt.scene.shapes).largest_extent()) / 8, 1e-12);
  std::vector<double> white;
  for (const Vec3f p : some_points(pbrt.scene))
    white.push_back(film * (shown(lights, p, nearest) + largest(around)));
  std::sort(white.begin(), white.end());
  if (white.empty() ||
      (white[white.size() * 9 / 10] > black && white[white.size() / 10] < blinding))
    return film;
  const std::vector<Light> before = lights;
  balance_lights(pbrt.scene);
  const double together = strength(before) / strength(lights) / pi + largest(around);
  lights = before;
  return 1 / together;
}

}  // namespace

void expose_pbrt(PbrtScene& pbrt) {
  Scene& scene = pbrt.scene;
  Color around = pbrt.surroundings.radiance;
  if (strength(scene.lights) > 0) {
    const double factor = exposure_of(pbrt, around);
    for (Light& light : scene.lights) light.intensity = times(light.intensity, factor / pi);
    for (Material& material : scene.materials) material.emission = times(material.emission, factor);
    around = times(around, factor);
    scene.ambient = around;
  } else if (pbrt.surroundings.place) {
    // Nothing here casts a shadow: lamps are hung up (complete_scene), beside which this is dim.
    constexpr double dim = 0.25;
    if (largest(around) > 0) scene.ambient = times(around, dim / largest(around));
    if (largest(around) > 1) around = times(around, 1 / largest(around));
    pbrt.warnings.add("the scene is lit by its surroundings alone; two lamps are added",
                      *pbrt.surroundings.place);
  }
  // A bare model is shown as one of any other format.
  if (!scene.lights.empty() || pbrt.surroundings.place) scene.background = around;
}

}  // namespace penumbra
