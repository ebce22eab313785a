// SPDX-License-Identifier: MIT
// The scenes of a plan.
#pragma once

#include <string>

#include "../scene_argument.h"
#include "plan.h"

namespace penumbra::reproduce {

/// A stand-in from its file; all others are built in, whatever files of their names there are.
inline Scene load(const Plan& plan, const std::string& scene) {
  for (const PlannedScene& planned : plan.scenes)
    if (planned.is_stand_in && planned.scene == scene) return load_scene(scene, {});
  return load_built_in_scene(scene);
}

}  // namespace penumbra::reproduce
