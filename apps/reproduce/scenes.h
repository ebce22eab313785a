// SPDX-License-Identifier: MIT
// The scenes of a plan, each read once.
#pragma once

#include <map>
#include <string>

#include "../scene_argument.h"
#include "plan.h"

namespace penumbra::reproduce {

class Scenes {
 public:
  /// Reads the stand-ins at once: a wrong name should not cost an hour. Throws Error.
  explicit Scenes(const Plan& plan) {
    for (const PlannedScene& planned : plan.scenes)
      if (planned.is_stand_in) scenes_.try_emplace(planned.scene, load_scene(planned.scene, {}));
  }

  /// All others are built in, whatever files of their names there are.
  const Scene& of(const std::string& name) {
    const auto found = scenes_.find(name);
    if (found != scenes_.end()) return found->second;
    return scenes_.emplace(name, load_built_in_scene(name)).first->second;
  }

 private:
  std::map<std::string, Scene> scenes_;
};

}  // namespace penumbra::reproduce
