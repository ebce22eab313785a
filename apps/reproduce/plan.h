// SPDX-License-Identifier: MIT
// What is measured: the paper's experiments at its settings, then ours.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "../bench_measure.h"
#include "measurement.h"

namespace penumbra::reproduce {

/// A scene of the paper, or what stands in for it.
struct PlannedScene {
  std::string scene;         ///< a file, or a built-in scene
  std::string light_radius;  ///< ours: the paper's are printed for Table 4 alone
  bool is_stand_in = false;  ///< a file, in place of the paper's
};

/// The scenes in the order of `paper_scenes`.
enum PaperSceneIndex { cylinders, balls4, rings, molecule, bust };

/// full: the paper's whole evaluation and ours; quick: fewer points and rounds, smaller pictures;
/// smoke: hardly any, to see that all of it works.
enum class Effort { full, quick, smoke };

inline constexpr std::array paper_order{cylinders, balls4, rings, molecule, bust};

/// The figure in which the paper shows the scene.
constexpr int figure_of(PaperSceneIndex scene) { return 9 + static_cast<int>(scene); }

/// A method that traces ray by ray, as tracers of the paper's time did.
constexpr Contender single(Method method) { return {method, RayGrouping::single}; }

struct Plan {
  Effort effort = Effort::full;
  std::array<PlannedScene, 5> scenes;
  std::uint32_t paper_size = 128;              ///< its pictures': smaller for a smoke test alone
  std::uint32_t rounds = 0, large_rounds = 0;  ///< of the tables; of all else
  std::vector<PaperSceneIndex> sample_scenes;  ///< time against d: three in the paper
  std::vector<std::uint32_t> sample_counts;
  std::uint32_t reference_samples = 0;  ///< of the pictures that errors are measured against
  std::vector<PaperSceneIndex> beyond_scenes;
  std::vector<std::string> light_radii;
  std::uint32_t large_size = 0;  ///< of pictures under these, and of growing scenes
  std::vector<std::uint32_t> sizes;
  std::string size_radius;           ///< of the light for pictures of these sizes
  std::vector<std::string> growing;  ///< ever more objects
  std::uint32_t picture_size = 0, picture_samples = 0, picture_spp = 0;
};

/// `molecule` and `bust`: empty, or files in place of the built-in scenes.
Plan make_plan(Effort effort, const std::string& molecule, const std::string& bust);

/// As it is asked for: "penumbra reproduce --quick --bust scan.ply".
std::string command_of(const Plan& plan);

/// All that the plan's measurements depend on, beside machine and version: effort, rounds, and the
/// size and time of files.
std::string name_of(const Plan& plan);

/// Settings that share a scene, a light and a size, and who answers them; Embree always does.
struct Task {
  std::string experiment, scene, light_radius;
  std::uint32_t size = 128;
  std::vector<std::uint32_t> shadow_samples;
  std::vector<Contender> contenders;
  std::uint32_t rounds = 1;
  std::uint32_t reference_samples = 0;  ///< 0: errors are not measured

  double cost() const;  ///< roughly, in any unit: what the time left is told by
};

std::vector<Task> tasks_of(const Plan& plan);

inline constexpr std::uint32_t paper_samples = 32;
inline constexpr const char* table4_scene = "balls:3";

/// The paper's (a) to (e), as tracers of its time did them.
std::vector<Contender> paper_contenders();

Setting setting_of(const Task& task, std::uint32_t shadow_samples);

// Of the experiments' tasks.
Setting table_setting(const Plan& plan, const PlannedScene& scene);
Setting table4_setting(const Plan& plan, std::size_t light);
Setting samples_setting(const Plan& plan, const PlannedScene& scene, std::uint32_t shadow_samples);
Setting light_setting(const Plan& plan, const PlannedScene& scene, const std::string& radius);
Setting size_setting(const Plan& plan, const PlannedScene& scene, std::uint32_t size);
Setting growth_setting(const Plan& plan, const std::string& scene);

}  // namespace penumbra::reproduce
