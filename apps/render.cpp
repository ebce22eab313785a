// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <CLI/App.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "commands.h"
#include "deferred_signals.h"
#include "options.h"
#include "penumbra/scene/error.h"
#include "penumbra/scene_io/image_io.h"
#include "penumbra/scene_io/write_scene.h"
#include "penumbra/trace/prepare.h"
#include "penumbra/trace/verify.h"
#include "progress.h"
#include "render_report.h"
#include "resources.h"
#include "scene_argument.h"
#include "scene_options.h"
#include "usage_error.h"

namespace penumbra {
namespace {

struct Options {
  std::string scene, output, stats;
  SceneWishes wishes;
  RenderOptions render;
  Method method = Method::shaft;
  std::optional<PixelSize> size;  ///< none: the camera's own
  std::optional<PixelPosition> pixel;
  float exposure_ev = 0;
  std::size_t verify = 0;  ///< answers to ask the judge about
  bool always_progress = false;
};

void add_picture_options(CLI::App& app, Options& o) {
  using Text = const std::string&;
  add_parsed(app, "-o,--output", "FILE", "The picture, .png or .exr", [&o](Text text) {
    o.output = parse_output(text, {".png", ".exr"});
  });
  add_parsed(app, "--size", "WxH", "Pixels (default: the file's, else 512x512)",
             [&o](Text text) { o.size = parse_size(text); });
  add_ray_options(app, o.render);
  add_parsed(app, "--exposure", "EV", "Brighten (> 0) or darken a PNG, in stops",
             [&o](Text text) { o.exposure_ev = static_cast<float>(parse_number(text, -64, 64)); });
  add_parsed(app, "--aov", "LIST", "EXR layers: any of class,visibility,depth,normal,samples",
             [&o](Text text) { o.render.aovs = parse_aovs(text); });
}

void add_shadow_options(CLI::App& app, Options& o) {
  add_method_option(app, o.method, "picture");
  add_shadow_samples_option(app, o.render.shadow_samples);
  add_parsed(app, "--verify", "N",
             "Compare N of the picture's answers with stochastic; fail if one differs",
             [&o](const std::string& text) { o.verify = parse_count(text, 1, 1u << 30); })
      ->group("Shadows");
  add_light_radius_option(app, o.wishes);
}

void add_picture_run_options(CLI::App& app, Options& o) {
  add_run_options(app, o.render.threads, o.stats, o.always_progress);
  using Text = const std::string&;
  const auto add = [&app](const char* name, const char* value, const char* help, auto parse) {
    add_parsed(app, name, value, help, parse)->group("Run");
  };
  add("--tile", "N", "Edge of the tiles threads take, in pixels (default 16)",
      [&o](Text text) { o.render.tile = static_cast<std::uint32_t>(parse_count(text, 1, 65536)); });
  add("--pixel", "x,y", "Print all about one pixel; writes nothing",
      [&o](Text text) { o.pixel = parse_pixel(text); });
}

constexpr const char* examples =
    "Examples:\n"
    "  penumbra render bust.ply -o bust.png\n"
    "  penumbra render balls:4 -o balls.png --shadow-samples 64 --light-radius 5%\n"
    "  penumbra render 1crn.pdb --style space-filling -o crambin.exr --aov class,depth\n"
    "  penumbra render chair.obj --light sphere 2 4 3 0.5 --light sun 0 1 1 0.53 -o chair.png\n"
    "  penumbra render room.rad --view \"-vp 1 -4 2 -vd 0 1 0 -vh 60 -vv 45\" -o room.png\n";

/// Checks what no single option can.
void check(const Options& o) {
  if (o.verify > 0 && o.method == Method::hard)
    throw UsageError("--verify: hard draws another picture than stochastic; choose another method");
  if (o.verify > 0 && o.pixel) throw UsageError("--verify is about a picture, --pixel draws none");
  if (o.pixel) return;
  if (o.output.empty()) throw UsageError("-o FILE is missing: where should the picture go?");
  if (!o.render.aovs.empty() && !has_extension(o.output, ".exr"))
    throw UsageError("--aov needs an .exr file; a PNG holds colours alone");
}

void take_size(Options& o, const Scene& scene) {
  const PixelSize size = o.size.value_or(PixelSize{scene.camera->width, scene.camera->height});
  o.render.width = size.width;
  o.render.height = size.height;
  if (o.pixel && (o.pixel->x >= size.width || o.pixel->y >= size.height))
    throw UsageError(fmt::format("--pixel {},{}: the picture has {}x{} pixels", o.pixel->x,
                                 o.pixel->y, size.width, size.height));
}

/// Draws the picture; `draw` gets some of its answers.
Picture render_with_progress(const Options& o, const Scene& scene, const ShadowScene& shadows,
                             AnswerDraw& draw) {
  Progress progress("rendering " + std::filesystem::path(o.scene).filename().string(),
                    o.always_progress ? ProgressWish::always : ProgressWish::on_terminal);
  RenderOptions options = o.render;
  options.progress = [&progress](double share) { progress.update(share); };
  if (o.verify > 0) options.observe = [&draw](const AnsweredBatch& batch) { draw.add(batch); };
  return render(scene, shadows, options);
}

/// Throws Error when an answer is not the judge's. Small scenes are judged by brute force.
std::size_t verify(const Options& o, const Scene& scene, const Kernel& kernel,
                   const AnswerDraw& draw) {
  constexpr std::size_t fewest_for_hierarchy = 10'000;
  const std::vector<GivenAnswer> answers = draw.answers();
  if (answers.empty()) return 0;
  std::optional<Kernel> brute;
  if (primitive_count(scene.shapes) < fewest_for_hierarchy) {
    KernelOptions options = kernel_options(scene);
    options.kind = KernelKind::brute;
    brute.emplace(scene.shapes, options);
  }
  const ShadowScene judge = prepare_shadows(scene, brute ? *brute : kernel, Method::stochastic);
  if (const auto wrong = find_wrong_answer(judge, o.render.shadow_samples, answers))
    throw Error(
        {o.scene, {}, {}},
        fmt::format("--verify: {} is wrong at {}", name_of(o.method), to_text(*wrong, o.render)),
        "nothing was written; this is a bug of penumbra's, please report it");
  fmt::print(stderr, "verified {} answers of {}\n", answers.size(), name_of(o.method));
  return answers.size();
}

int run(Options o, const std::vector<std::string>& arguments) {
  o.scene = take_scene(o.wishes, o.scene, "SCENE", "a file, or the name of a built-in scene");
  finish(o.wishes);
  check(o);
  if (!o.pixel) {
    check_files_differ(o.scene, o.output);
    check_files_differ(o.scene, o.stats);
    check_files_differ(o.output, o.stats);
    check_image_path(o.output);
  }
  if (!o.pixel && !o.stats.empty()) check_output_path(o.stats);

  RenderReport report{o.scene, arguments, {}, o.method, 0, 0, 0, 0, 0};
  const double start = now_seconds();
  const Scene scene = complete_scene(load_scene(o.scene, o.wishes.read), o.wishes.complete);
  take_size(o, scene);
  const double loaded = now_seconds();
  const Kernel kernel(scene.shapes, kernel_options(scene));
  const ShadowScene shadows = prepare_shadows(scene, kernel, o.method);
  report.load_seconds = loaded - start;
  report.build_seconds = now_seconds() - loaded;
  report.geometry_bytes = kernel.memory_bytes();
  report.shadow_bytes = shadows.memory_bytes();
  report.options = o.render;

  if (o.pixel) {
    fmt::print("{}", explain_pixel(scene, shadows, o.render, o.pixel->x, o.pixel->y));
    return 0;
  }
  AnswerDraw draw(o.verify, o.render.seed);
  Picture picture = render_with_progress(o, scene, shadows, draw);
  report.verified = verify(o, scene, kernel, draw);
  add_metadata(report, picture);
  const DeferredSignals until_written;
  write_image(o.output, picture.image, o.exposure_ev);
  if (!o.stats.empty()) write_file(o.stats, stats_json(report, picture));
  fmt::print(stderr, "{}\n", summary(o.output, picture));
  return 0;
}

}  // namespace

Command add_render(CLI::App& program, const std::vector<std::string>& arguments) {
  CLI::App* app = program.add_subcommand("render", "Render a scene to a picture");
  const auto options = std::make_shared<Options>();
  app->add_option("SCENE", options->scene, scene_argument_help);
  add_picture_options(*app, *options);
  add_shadow_options(*app, *options);
  add_scene_options(*app, options->wishes);
  add_picture_run_options(*app, *options);
  app->footer(std::string(lights_help) + examples);
  return {app, [options, arguments] { return run(*options, arguments); }};
}

}  // namespace penumbra
