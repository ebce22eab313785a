// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/light_emitters.h"

#include <fmt/format.h>

#include "penumbra/scene/emitters.h"

namespace penumbra {

void light_emitters(Scene& scene, Warnings& warnings) {
  const EmitterReport report = add_emitter_lights(scene);
  if (report.joined > 0)
    warnings.add(fmt::format("{} glowing surfaces light the scene as {} light{}", report.surfaces,
                             report.lights, report.lights == 1 ? "" : "s"));
  if (report.dark > 0)
    warnings.add(fmt::format("{} glowing surface{} too small or thin to light the scene",
                             report.dark, report.dark == 1 ? " is" : "s are"));
  constexpr double noticeable = 0.2;
  if (report.misdirected > noticeable)
    warnings.add(
        fmt::format("of the light of glowing surfaces {:.0f} % goes where it should not, since "
                    "their shapes are simplified",
                    100 * report.misdirected));
}

}  // namespace penumbra
