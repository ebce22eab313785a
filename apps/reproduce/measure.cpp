// SPDX-License-Identifier: MIT
#include "measure.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <ctime>
#include <optional>
#include <utility>

#include "../image_difference.h"
#include "../options.h"
#include "penumbra/trace/prepare.h"

namespace penumbra::reproduce {
namespace {

using Tell = std::function<void(double)>;

RenderOptions options_of(const Task& task) {
  RenderOptions options;
  options.width = options.height = task.size;
  options.pixel_point = PixelPoint::corner;
  options.threads = 1;
  return options;
}

/// Errors of pictures: to one with far more samples, and other ones.
class Errors {
 public:
  Errors(const BenchScene& bench, std::uint32_t reference_samples)
      : bench_(bench), shaft_(prepare_shadows(bench.scene, bench.kernel, Method::shaft)) {
    RenderOptions options = bench.options;
    options.shadow_samples = reference_samples;
    options.seed = options.seed + 1;
    reference_ = render(bench.scene, shaft_, options).image;
  }

  /// By `shaft`: all methods draw the same picture, which the bench checks.
  double of(std::uint32_t shadow_samples) const {
    RenderOptions options = bench_.options;
    options.shadow_samples = shadow_samples;
    return difference(render(bench_.scene, shaft_, options).image, reference_, {}).rmse;
  }

 private:
  const BenchScene& bench_;
  ShadowScene shaft_;
  Image reference_;
};

std::vector<Measurement> measured(const BenchScene& bench, const Setting& setting,
                                  std::uint32_t rounds, const Errors* errors, const Tell& tell) {
  std::vector<Measurement> all;
  const std::string today = fmt::format("{:%F}", fmt::gmtime(std::time(nullptr)));
  const double rmse = errors ? errors->of(setting.shadow_samples) : -1;
  for (BenchRow& row : measure(bench, setting.scene, setting.shadow_samples, rounds, tell)) {
    all.push_back({setting,
                   std::move(row),
                   primitive_count(bench.scene.shapes),
                   bench.scene.lights.size(),
                   bench.work.queries.size(),
                   rmse,
                   rounds,
                   today,
                   {}});
  }
  return all;
}

/// What the journal lacks of a task.
Task missing(Task task, const Journal& journal) {
  std::erase_if(task.shadow_samples, [&](std::uint32_t d) {
    const Setting setting = setting_of(task, d);
    std::vector<std::string> methods{embree, embree_hard};
    for (const Contender contender : task.contenders) methods.push_back(name_of(contender));
    return std::all_of(methods.begin(), methods.end(), [&](const std::string& method) {
      return journal.find(setting, method) != nullptr;
    });
  });
  return task;
}

void run(const Task& task, const Scene& loaded, Journal& journal, const Tell& tell) {
  SceneOptions wishes;
  wishes.light_radius = parse_light_radius(task.light_radius);
  const Scene scene = complete_scene(loaded, wishes);
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const BenchScene bench(scene, {task.contenders, {}}, options_of(task));
  std::optional<Errors> errors;
  if (task.reference_samples > 0) errors.emplace(bench, task.reference_samples);
  for (std::size_t i = 0; i < task.shadow_samples.size(); ++i) {
    const double count = static_cast<double>(task.shadow_samples.size());
    journal.add(measured(bench, setting_of(task, task.shadow_samples[i]), task.rounds,
                         errors ? &*errors : nullptr,
                         [&](double share) { tell((static_cast<double>(i) + share) / count); }));
  }
}

}  // namespace

void measure_all(const Plan& plan, Scenes& scenes, Journal& journal,
                 const std::function<void(double)>& progress) {
  std::vector<Task> tasks;
  double all = 0, done = 0;
  for (const Task& task : tasks_of(plan)) {
    tasks.push_back(missing(task, journal));
    if (!tasks.back().shadow_samples.empty()) all += tasks.back().cost();
  }
  for (const Task& task : tasks) {
    if (task.shadow_samples.empty()) continue;
    run(task, scenes.of(task.scene), journal,
        [&](double share) { progress((done + share * task.cost()) / all); });
    done += task.cost();
  }
}

}  // namespace penumbra::reproduce
