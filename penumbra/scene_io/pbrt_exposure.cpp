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

double largest(Color color) { return static_cast<double>(max_abs(color)); }

/// What the film makes of radiance.
double film_factor(const PbrtScene& pbrt) {
  double factor = 1;
  if (pbrt.film) factor *= pbrt.film->params.number("iso", 100) / 100;
  if (pbrt.camera)
    factor *= pbrt.camera->params.number("shutterclose", 1) -
              pbrt.camera->params.number("shutteropen", 0);
  return factor > 0 && std::isfinite(factor) ? factor : 1;
}

/// The factor of radiances: the film's, unless nine in ten points are then black, or blinding;
/// else that of `balance_lights`.
double exposure_of(const PbrtScene& pbrt, Color around) {
  constexpr double black = 1.0 / 50, blinding = 50;
  const double film = film_factor(pbrt);
  const std::vector<double> lit = irradiances(pbrt.scene);
  if (lit.empty()) return film;
  const auto white = [&](std::size_t tenth) {
    return lit[lit.size() * tenth / 10] / pi + largest(around);
  };
  return film * white(9) > black && film * white(1) < blinding ? film : 1 / white(9);
}

}  // namespace

void expose_pbrt(PbrtScene& pbrt) {
  Scene& scene = pbrt.scene;
  Color around = pbrt.surroundings.radiance;
  if (!scene.lights.empty()) {
    const double factor = exposure_of(pbrt, around);
    for (Light& light : scene.lights) light.intensity = scaled(light.intensity, factor / pi);
    for (Material& material : scene.materials)
      material.emission = scaled(material.emission, factor);
    around = scaled(around, factor);
    scene.ambient = around;
  } else if (pbrt.surroundings.place) {
    // Nothing here casts a shadow: lamps are hung up (complete_scene), beside which this is dim.
    constexpr double dim = 0.25;
    if (largest(around) > 0) scene.ambient = scaled(around, dim / largest(around));
    if (largest(around) > 1) around = scaled(around, 1 / largest(around));
    pbrt.warnings.add("the scene is lit by its surroundings alone; two lamps are added",
                      *pbrt.surroundings.place);
  }
  // A bare model is shown as one of any other format.
  if (!scene.lights.empty() || pbrt.surroundings.place) scene.background = around;
}

}  // namespace penumbra
