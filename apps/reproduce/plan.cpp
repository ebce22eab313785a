// SPDX-License-Identifier: MIT
#include "plan.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include "paper.h"

namespace penumbra::reproduce {
namespace {

constexpr Contender plain{Method::stochastic}, shaft{Method::shaft}, umbra{Method::umbra};

/// Of a stand-in, what tells that it is still the same file.
std::string file_stamp(const std::string& name) {
  struct stat status {};
  if (::stat(name.c_str(), &status) != 0) return name;
  return fmt::format("{} ({} bytes, {:%F %T})", name, status.st_size, fmt::gmtime(status.st_mtime));
}

std::vector<Contender> table_contenders() {
  std::vector<Contender> all = paper_contenders();
  for (const Contender today : {plain, umbra, shaft}) all.push_back(today);
  return all;
}

}  // namespace

std::vector<Contender> paper_contenders() {
  return {single(Method::hard), single(Method::stochastic), single(Method::offset),
          single(Method::reduced), single(Method::umbra)};
}

Plan make_plan(Effort effort, const std::string& molecule_file, const std::string& bust_file) {
  Plan p;
  p.effort = effort;
  p.scenes = {{{"cylinders", "0.1"},
               {"balls:4", "0.00617284"},  // that of its smallest balls
               {"rings", "0.05"},
               {"molecule", "1%"},
               {"bust", "1%"}}};
  const auto stand_in = [&](PaperSceneIndex scene, const std::string& file) {
    if (!file.empty()) p.scenes[scene].scene = file, p.scenes[scene].is_stand_in = true;
  };
  stand_in(molecule, molecule_file);
  stand_in(bust, bust_file);
  p.size_radius = "5%";
  p.sample_scenes = {cylinders, molecule, bust, balls4};
  p.beyond_scenes = {balls4, molecule, bust};
  int largest = 6;
  switch (effort) {
    case Effort::full:
      p.rounds = 9, p.large_rounds = 5;
      p.sample_counts = {1, 2, 4, 8, 16, 32, 64, 128, 256, 512}, p.reference_samples = 4096;
      p.light_radii = {"0.5%", "1%", "2%", "5%", "10%", "20%", "50%"}, p.large_size = 512;
      p.sizes = {64, 128, 256, 512, 1024};
      p.picture_size = 1024, p.picture_samples = 64, p.picture_spp = 16;
      break;
    case Effort::quick:
      p.rounds = 3, p.large_rounds = 3;
      p.sample_scenes = {cylinders, molecule, bust};  // those of the paper
      p.sample_counts = {1, 8, 32, 128}, p.reference_samples = 1024;
      p.light_radii = {"1%", "5%", "20%"}, p.large_size = 192;
      p.sizes = {64, 128, 256};
      p.picture_size = 512, p.picture_samples = 16, p.picture_spp = 4;
      largest = 5;
      break;
    case Effort::smoke:
      p.paper_size = 32, p.rounds = 1, p.large_rounds = 1;
      p.sample_scenes = {cylinders}, p.beyond_scenes = {balls4};
      p.sample_counts = {1, 8}, p.reference_samples = 64;
      p.light_radii = {"5%", "20%"}, p.large_size = 32;
      p.sizes = {16, 32};
      p.picture_size = 64, p.picture_samples = 4, p.picture_spp = 1;
      largest = 2;
      break;
  }
  for (int n = 1; n <= largest; ++n) p.growing.push_back(fmt::format("balls:{}", n));
  return p;
}

std::string command_of(const Plan& plan) {
  std::string command = "penumbra reproduce";
  if (plan.effort == Effort::quick) command += " --quick";
  if (plan.effort == Effort::smoke) command += " --smoke";
  if (plan.scenes[molecule].is_stand_in) command += " --molecule " + plan.scenes[molecule].scene;
  if (plan.scenes[bust].is_stand_in) command += " --bust " + plan.scenes[bust].scene;
  return command;
}

std::string name_of(const Plan& plan) {
  std::string name = fmt::format("{}, {} and {} rounds, errors to d = {}", command_of(plan),
                                 plan.rounds, plan.large_rounds, plan.reference_samples);
  for (const PlannedScene& scene : plan.scenes)
    if (scene.is_stand_in) name += "; " + file_stamp(scene.scene);
  return name;
}

double Task::cost() const {
  double samples = 0;
  for (const std::uint32_t d : shadow_samples) samples += d + 16;
  const double pixels = double(size) * size;
  const double once = samples * pixels * (3 + double(contenders.size()) * rounds) + 5e7;
  return once + reference_samples * pixels;
}

std::vector<Task> tasks_of(const Plan& plan) {
  std::vector<Task> tasks;
  const auto add = [&](const Setting& s, std::vector<Contender> contenders, std::uint32_t rounds) {
    tasks.push_back({s.experiment,
                     s.scene,
                     s.light_radius,
                     s.size,
                     {s.shadow_samples},
                     std::move(contenders),
                     rounds});
  };
  for (const PlannedScene& scene : plan.scenes)
    add(table_setting(plan, scene), table_contenders(), plan.rounds);
  for (std::size_t i = 0; i < paper_lights.size(); ++i)
    add(table4_setting(plan, i), table_contenders(), plan.rounds);
  for (const PaperSceneIndex i : plan.sample_scenes) {
    add(samples_setting(plan, plan.scenes[i], 0),
        {single(Method::stochastic), single(Method::reduced), single(Method::umbra), plain, shaft},
        plan.large_rounds);
    tasks.back().shadow_samples = plan.sample_counts;
    tasks.back().reference_samples = plan.reference_samples;
  }
  const std::vector<Contender> today{plain, shaft};
  for (const PaperSceneIndex i : plan.beyond_scenes) {
    for (const std::string& radius : plan.light_radii)
      add(light_setting(plan, plan.scenes[i], radius), today, plan.large_rounds);
    for (const std::uint32_t size : plan.sizes)
      add(size_setting(plan, plan.scenes[i], size), today, plan.large_rounds);
  }
  for (const std::string& scene : plan.growing)
    add(growth_setting(plan, scene), today, plan.large_rounds);
  return tasks;
}

Setting setting_of(const Task& task, std::uint32_t shadow_samples) {
  return {task.experiment, task.scene, task.light_radius, task.size, shadow_samples};
}

Setting table_setting(const Plan& plan, const PlannedScene& scene) {
  return {"tables", scene.scene, scene.light_radius, plan.paper_size, paper_samples};
}

Setting table4_setting(const Plan& plan, std::size_t light) {
  return {"table 4", table4_scene, fmt::format("{:.6g}", paper_lights[light].value),
          plan.paper_size, paper_samples};
}

Setting samples_setting(const Plan& plan, const PlannedScene& scene, std::uint32_t shadow_samples) {
  return {"samples", scene.scene, scene.light_radius, plan.paper_size, shadow_samples};
}

Setting light_setting(const Plan& plan, const PlannedScene& scene, const std::string& radius) {
  return {"light", scene.scene, radius, plan.large_size, paper_samples};
}

Setting size_setting(const Plan& plan, const PlannedScene& scene, std::uint32_t size) {
  return {"size", scene.scene, plan.size_radius, size, paper_samples};
}

Setting growth_setting(const Plan& plan, const std::string& scene) {
  return {"growth", scene, plan.size_radius, plan.large_size, paper_samples};
}

}  // namespace penumbra::reproduce
