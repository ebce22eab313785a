// SPDX-License-Identifier: MIT
// Options of commands that draw a scene, or ask about it: camera, lights, ground, what readers ask,
// rays, shadows, and how commands run.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "penumbra/scene/complete_scene.h"
#include "penumbra/scene_io/read_scene.h"
#include "penumbra/trace/render.h"

namespace CLI {
class App;  // the library takes long to compile
}

namespace penumbra {

/// What the user wants of a scene.
struct SceneWishes {
  ReadOptions read;
  SceneOptions complete;
  std::vector<std::string> light_words;  ///< after all `--light` options
  std::string view;                      ///< of Radiance, as options or a file; empty: none
};

/// `wishes` must live until the command line is parsed.
void add_scene_options(CLI::App& command, SceneWishes& wishes);

/// Of them `--up` and `--ground`; which ground there is without.
void add_ground_options(CLI::App& command, SceneWishes& wishes, GroundChoice by_default);

/// Those of them that say what shines and what blocks: `--light` and `--clear-glass`.
void add_light_options(CLI::App& command, SceneWishes& wishes);

/// Adds `--light-radius`.
void add_light_radius_option(CLI::App& command, SceneWishes& wishes);

/// Adds `--seed`.
void add_seed_option(CLI::App& command, std::uint64_t& seed);

/// Adds `--spp`, `--depth` and `--seed`.
void add_ray_options(CLI::App& command, RenderOptions& options);

/// Adds `--method`, where what is made is known whole beforehand: a "picture", a "texture".
void add_method_option(CLI::App& command, Method& method, const std::string& product);

/// Adds `--shadow-samples`.
void add_shadow_samples_option(CLI::App& command, std::uint32_t& shadow_samples);

/// Adds `--threads`, `--stats` and `--progress`.
void add_run_options(CLI::App& command, std::uint32_t& threads, std::string& stats,
                     bool& always_progress);

/// How lights are written, for a command's footer.
extern const char* const lights_help;

/// The words of --light have no end of their own: takes back the scenes that stand behind them,
/// which are missing when `scenes` is empty.
void take_back_scenes(SceneWishes& wishes, std::vector<std::string>& scenes);

/// The one scene of a command: as `given`, or taken back. Throws UsageError where there is none, or
/// more than one; `name` is the argument's, `what` explains it.
std::string take_scene(SceneWishes& wishes, const std::string& given, const std::string& name,
                       const std::string& what);

/// After the command line is parsed: fills in the lights and the view, and checks what no single
/// option can. Throws UsageError, and Error for a view that cannot be read.
void finish(SceneWishes& wishes);

}  // namespace penumbra
