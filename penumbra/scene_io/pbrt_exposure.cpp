// SPDX-License-Identifier: MIT
// A white surface shows I / distance² here and I / (pi distance²) there, so lights get 1 / pi of
// the factor that radiances get.
#include <algorithm>
#include <cmath>
#include <numbers>
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

/// The factor of radiances: the film's, if that of `balance_lights` is at all like it. Leaves the
/// lights balanced.
double exposure_of(const PbrtScene& pbrt, Scene& scene) {
  constexpr double unlike = 50;
  const double film = film_factor(pbrt), before = strength(scene.lights);
  balance_lights(scene);
  const double balanced = pi * strength(scene.lights) / before;
  const double ratio = film / balanced;
  return ratio > 1 / unlike && ratio < unlike ? film : balanced;
}

}  // namespace

void expose_pbrt(PbrtScene& pbrt) {
  Scene& scene = pbrt.scene;
  Color around = pbrt.surroundings.radiance;
  const std::vector<Light> lights = scene.lights;
  if (strength(lights) > 0) {
    const double factor = exposure_of(pbrt, scene);
    for (std::size_t i = 0; i < lights.size(); ++i)
      scene.lights[i].intensity = times(lights[i].intensity, factor / pi);
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
  scene.background = around;
}

}  // namespace penumbra
