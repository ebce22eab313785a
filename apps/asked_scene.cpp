// SPDX-License-Identifier: MIT
#include "asked_scene.h"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

#include "penumbra/scene/error.h"
#include "penumbra/scene_io/light_spec.h"
#include "scene_argument.h"

namespace penumbra {

Scene load_asked_scene(const std::string& name, const SceneWishes& wishes) {
  Scene scene = load_scene(name, wishes.read);
  if (scene.lights.empty() && wishes.complete.lights.empty())
    throw Error({name, {}, {}}, "has no lights",
                "give them, as in --light sun 0 0 1 0.53 or --light sphere 2 4 3 0.5");
  scene.camera.reset();  // whatever is wrong with it is no matter
  return complete_scene(std::move(scene), wishes.complete);
}

void name_lights(const Scene& scene) {
  constexpr std::size_t most = 16, longest = 100;
  for (std::size_t i = 0; i < scene.lights.size() && i < most; ++i) {
    Light light = scene.lights[i];
    light.beam.reset();
    const std::string words = light_words(light);
    fmt::print(stderr, "light{}: {}{}\n", i, words.substr(0, longest),
               words.size() > longest ? "..." : "");
  }
  if (scene.lights.size() > most) fmt::print(stderr, "... {} lights\n", scene.lights.size());
}

}  // namespace penumbra
