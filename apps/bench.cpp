// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <CLI/App.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "bench_measure.h"
#include "bench_report.h"
#include "commands.h"
#include "machine.h"
#include "options.h"
#include "penumbra/scene/error.h"
#include "penumbra/scene_io/image_io.h"
#include "penumbra/scene_io/write_scene.h"
#include "progress.h"
#include "scene_argument.h"
#include "scene_options.h"

namespace penumbra {
namespace {

/// A radius as it was given, which is how it is told.
struct Radius {
  std::string text;
  LightRadius value;
};

/// The judge is always among them; the same method counts once.
std::vector<Contender> contenders(std::vector<Method> wanted) {
  wanted.push_back(Method::stochastic);
  std::vector<Contender> methods;
  for (const Method method : all_methods())
    if (std::find(wanted.begin(), wanted.end(), method) != wanted.end())
      methods.push_back({method});
  return methods;
}

struct Options {
  std::vector<std::string> scenes;
  SceneWishes wishes;
  RenderOptions render;
  BenchMethods methods{contenders(all_methods()), {}};
  std::vector<std::uint32_t> shadow_samples{32}, threads{1};
  std::vector<std::optional<Radius>> radii{std::nullopt};
  std::optional<PixelSize> size;  ///< none: the camera's own
  std::uint32_t rounds = 5;
  std::string json;
};

constexpr const char* examples =
    "Every cell (scene, radius, d) asks the questions of visibility of one picture, reflections "
    "and\n"
    "refractions included, in the batches in which the renderer asks them. Each round asks all\n"
    "methods once, in turn; times are medians over the rounds. `embree` traces the same samples "
    "in\n"
    "Embree's packets, `embree_hard` one ray a point and light, each by the fastest of Embree's "
    "calls\n"
    "there. The render time of the two is an estimate: that of `stochastic`, with its shadow time\n"
    "replaced by theirs. `stochastic` always takes part. Answers of our other methods (but "
    "`hard`)\n"
    "that differ from it are an error; Embree's triangles may differ in a few samples.\n\n"
    "Columns: shadow, the time for all questions; x embree and x stoch, its speed-up over those\n"
    "rows; / hard, its ratio to `embree_hard`; lit, pen., umbra, the questions by class, which "
    "for\n"
    "methods that prove means proven (`stochastic` tells the truth of its samples); render, a "
    "whole\n"
    "picture, timed by itself; build, hierarchy and what the method prepares; MB, of both. A run\n"
    "takes several times what its tables add up to: choosing Embree's fastest call, checking.\n\n"
    "Examples:\n"
    "  penumbra bench balls:4 bust --shadow-samples 32,256 --light-radius 1%,5%,15% --json b.json\n"
    "  penumbra bench city.glb --light sun 0.3 1 0.2 0.53 --methods shaft --size 256x256\n"
    "  penumbra bench --threads 1,0                 # the built-in scenes, one thread and all\n";

std::uint32_t count(const std::string& text, std::uint64_t least, std::uint64_t most) {
  return static_cast<std::uint32_t>(parse_count(text, least, most));
}

std::uint32_t thread_count(const std::string& text) {
  const std::uint32_t threads = count(text, 0, 1024);
  return threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency());
}

void add_options(CLI::App& app, Options& o) {
  using Text = const std::string&;
  const auto add = [&app](const char* name, const char* value, const char* help, auto parse) {
    add_parsed(app, name, value, help, parse);
  };
  add("--methods", "LIST", "Such as stochastic,shaft (default: all)", [&o](Text text) {
    std::vector<Method> wanted;
    for (Text name : parse_list(text)) wanted.push_back(parse_method(name));
    o.methods.methods = contenders(std::move(wanted));
  });
  add("--shadow-samples", "LIST", "Samples a point and light (default 32)", [&o](Text text) {
    o.shadow_samples.clear();
    for (Text part : parse_list(text)) o.shadow_samples.push_back(count(part, 1, 65536));
  });
  add("--light-radius", "LIST", "Of point and ball lights; N% of the extent (default: as they are)",
      [&o](Text text) {
        o.radii.clear();
        for (Text part : parse_list(text))
          o.radii.push_back(Radius{part, parse_light_radius(part)});
      });
  add("--size", "WxH", "Pixels (default: the file's, else 512x512)",
      [&o](Text text) { o.size = parse_size(text); });
  add("--threads", "LIST", "0 takes all (default 1)", [&o](Text text) {
    o.threads.clear();
    for (Text part : parse_list(text)) o.threads.push_back(thread_count(part));
  });
  add("--embree-spheres", "KIND",
      "native, or user (as user geometry); default: whichever is faster",
      [&o](Text text) { o.methods.spheres = parse_embree_spheres(text); });
  add("--rounds", "N", "Of everything; medians over them are told (default 5)",
      [&o](Text text) { o.rounds = count(text, 1, 1000); });
  app.add_option("--json", o.json, "Write the rows as JSON")->type_name("FILE");
  add_ray_options(app, o.render);
  add_scene_options(app, o.wishes);
}

/// All cells of a scene.
void run_scene(const Options& o, const std::string& name, const Scene& loaded,
               std::vector<BenchCell>& cells) {
  for (const std::optional<Radius>& radius : o.radii) {
    SceneOptions wishes = o.wishes.complete;
    if (radius) wishes.light_radius = radius->value;
    const Scene scene = complete_scene(loaded, wishes);
    RenderOptions render = o.render;
    const PixelSize size = o.size.value_or(PixelSize{scene.camera->width, scene.camera->height});
    render.width = size.width, render.height = size.height;
    for (const std::uint32_t threads : o.threads) {
      const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, threads);
      render.threads = threads;
      const BenchScene bench(scene, o.methods, render);
      for (const std::uint32_t d : o.shadow_samples) {
        BenchCell cell{name, {}, size, threads, d, render.seed, bench.work.queries.size(), {}};
        if (radius) cell.light_radius = radius->text;
        {
          Progress progress(fmt::format("bench {}, d = {}", name, d), ProgressWish::on_terminal);
          cell.rows =
              measure(bench, name, d, o.rounds, [&](double share) { progress.update(share); });
        }
        fmt::print("{}\n", to_text(cell));
        std::fflush(stdout);
        cells.push_back(std::move(cell));
      }
    }
  }
}

int run(Options o) {
  take_back_scenes(o.wishes, o.scenes);
  finish(o.wishes);
  if (o.scenes.empty()) o.scenes = {"cylinders", "balls:4", "rings", "molecule", "bust"};
  if (!o.json.empty()) check_output_path(o.json);
  fmt::print("{}\n\n", to_text(this_machine()));
  std::vector<BenchCell> cells;
  std::vector<Scene> loaded;  // first of all: a wrong name should not cost the others' results
  for (const std::string& scene : o.scenes) loaded.push_back(load_scene(scene, o.wishes.read));
  for (std::size_t i = 0; i < loaded.size(); ++i) run_scene(o, o.scenes[i], loaded[i], cells);
  if (!o.json.empty()) write_file(o.json, to_json(cells));
  return 0;
}

}  // namespace

Command add_bench(CLI::App& program) {
  CLI::App* app = program.add_subcommand("bench", "Time the methods side by side, and Embree");
  const auto options = std::make_shared<Options>();
  app->add_option("SCENE", options->scenes,
                  std::string(scene_argument_help) + "; none: the five built-in ones");
  add_options(*app, *options);
  app->footer(std::string(lights_help) + examples);
  return {app, [options] { return run(*options); }};
}

}  // namespace penumbra
