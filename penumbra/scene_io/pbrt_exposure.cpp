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

/// The factor of radiances: the film's, if a white surface that faces all lights is then neither
/// black nor blinding (as `balance_lights` has it: beside the objects); else what makes it white.
double exposure_of(PbrtScene& pbrt, Color around) {
  constexpr double unlike = 50;
  std::vector<Light> lights = pbrt.scene.lights;
  balance_lights(pbrt.scene);
  const double together = strength(lights) / strength(pbrt.scene.lights) / pi;
  pbrt.scene.lights = std::move(lights);
  const double film = film_factor(pbrt), white = film * (together + largest(around));
  return white > 1 / unlike && white < unlike ? film : film / white;
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
  scene.background = around;
}

}  // namespace penumbra
