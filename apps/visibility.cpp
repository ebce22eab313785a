// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <CLI/App.hpp>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "answer_points.h"
#include "asked_scene.h"
#include "commands.h"
#include "options.h"
#include "penumbra/scene_io/image_io.h"
#include "penumbra/scene_io/read_points.h"
#include "penumbra/scene_io/write_answers.h"
#include "penumbra/scene_io/write_scene.h"
#include "penumbra/trace/names.h"
#include "penumbra/version.h"
#include "progress.h"
#include "remove_on_signal.h"
#include "resources.h"
#include "scene_argument.h"
#include "scene_options.h"
#include "usage_error.h"

namespace penumbra {
namespace {

struct Options {
  std::string scene, points, output = "-", stats;
  SceneWishes wishes;
  AnswerOptions answer;
  std::optional<PointFormat> input_format;
  std::optional<AnswerFormat> output_format;
  bool has_classes = false, has_fractions = false;
  std::size_t block = std::size_t{1}
                      << 18;  ///< points that are read, answered and written together
  bool always_progress = false;
};

/// What a run took and found.
struct Account {
  std::uint64_t points = 0;
  double load = 0, build = 0, read = 0, answer = 0, write = 0;  ///< seconds
  std::size_t memory_bytes = 0;
  ShadowCounters counters;
};

AnswerFormat format_by_name(const std::string& name) {
  if (name.empty() || name == "-" || has_extension(name, ".csv")) return AnswerFormat::csv;
  if (has_extension(name, ".npy")) return AnswerFormat::npy;
  if (has_extension(name, ".ply")) return AnswerFormat::ply;
  if (has_extension(name, ".txt")) return AnswerFormat::ascii;
  throw UsageError(
      fmt::format("-o {}: expected a name that ends in .csv, .txt, .npy or .ply; for others say "
                  "--output-format",
                  name));
}

AnswerLayout layout_of(const Options& o, const Scene& scene, bool has_normals) {
  AnswerLayout layout;
  layout.format = o.output_format ? *o.output_format : format_by_name(o.output);
  layout.lights = scene.lights.size();
  layout.has_normals = has_normals;
  for (const auto c : {ShadowClass::lit, ShadowClass::penumbra, ShadowClass::umbra})
    layout.class_names.emplace_back(name_of(c));
  const bool is_table = layout.format == AnswerFormat::csv || layout.format == AnswerFormat::ply;
  const bool says_nothing = !o.has_classes && !o.has_fractions;
  layout.has_fractions = o.has_fractions || says_nothing;
  layout.has_classes = o.has_classes || (says_nothing && is_table);
  return layout;
}

void add_file_options(CLI::App& app, Options& o) {
  using Text = const std::string&;
  app.add_option("--points", o.points, "Points, with normals or without; - is standard input")
      ->type_name("FILE|-");
  app.add_option("-o,--output", o.output,
                 "Where to: .csv, .txt, .npy, .ply (default -, standard output, as CSV)")
      ->type_name("FILE|-");
  add_parsed(app, "--input-format", "F", "csv, ply, npy, float or double (default: as it looks)",
             [&o](Text text) { o.input_format = parse_point_format(text); });
  add_parsed(app, "--output-format", "F",
             "csv, ascii, npy, ply, float or double (default: by the name)",
             [&o](Text text) { o.output_format = parse_answer_format(text); });
  app.add_flag("--classes", o.has_classes,
               "Write classes; alone: more is proven, and no sample taken");
  app.add_flag("--fractions", o.has_fractions,
               "Write visible fractions (default: in CSV and PLY both, elsewhere fractions)");
}

void add_question_options(CLI::App& app, Options& o) {
  using Text = const std::string&;
  add_ground_options(app, o.wishes, GroundChoice::none);
  add_parsed(app, "--method", "M",
             "shaft (default) or stochastic: the same fractions; the others need a whole picture",
             [&o](Text text) { o.answer.method = parse_asking_method(text); })
      ->group("Shadows");
  add_shadow_samples_option(app, o.answer.shadow_samples);
  add_light_radius_option(app, o.wishes);
  add_seed_option(app, o.answer.seed);
  add_parsed(app, "--offset", "auto|DISTANCE",
             "How far points are moved along their normals, off their own surface (default auto)",
             [&o](Text text) {
               o.answer.offset.reset();
               if (text != "auto")
                 o.answer.offset = static_cast<float>(parse_number(text, 0, 1e15));
             })
      ->group("Shadows");
}

void add_stream_options(CLI::App& app, Options& o) {
  using Text = const std::string&;
  add_run_options(app, o.answer.threads, o.stats, o.always_progress);
  add_parsed(app, "--block", "N",
             "Points that are answered together (default 262144); 1: each as it comes",
             [&o](Text text) { o.block = parse_count(text, 1, std::uint64_t{1} << 24); })
      ->group("Run");
}

constexpr const char* examples =
    "Points are lines of `x y z` or `x y z nx ny nz` (CSV: with or without a line of names), PLY,\n"
    "NumPy's .npy (N x 3 or N x 6), or what Radiance's tools pass on (--input-format float, "
    "double).\n"
    "For each light: the class (lit and umbra are proven, penumbra is neither) and the share of "
    "its\n"
    "samples that the point sees. Samples below a point's horizon are not seen; points without\n"
    "normals have no horizon.\n\n"
    "Examples:\n"
    "  penumbra visibility city.ply --points facade.csv --light sun 0.3 -1 0.5 0.53 > seen.csv\n"
    "  penumbra visibility bust --points grid.npy -o seen.npy --shadow-samples 256\n"
    "  penumbra visibility lamp.glb --points scan.ply -o seen.ply --light-radius 0.05\n"
    "  vwrays -ff view.vf | rtrace -h -ff -opN room.oct |\n"
    "    penumbra visibility room.rad --points - --input-format float --output-format float > "
    "v.dat\n"
    "  echo 0 0 0 0 0 1 | penumbra visibility bust --points - --output-format ascii\n";

/// Checks what no single option can.
void check(const Options& o) {
  if (o.points.empty())
    throw UsageError("--points FILE is missing: which points? (- for the standard input)");
  const AnswerFormat format = o.output_format ? *o.output_format : format_by_name(o.output);
  const bool is_raw = format == AnswerFormat::float32 || format == AnswerFormat::float64;
  if (is_raw && o.has_classes && o.has_fractions)
    throw UsageError("float and double hold one kind of number: take --classes or --fractions");
  check_files_differ(o.scene, o.output);
  check_files_differ(o.points, o.output);
  for (const std::string& other : {o.scene, o.points, o.output}) check_files_differ(other, o.stats);
  if (!o.stats.empty()) check_output_path(o.stats);
}

/// Runs and adds the seconds it took.
template <typename Work>
auto timed(double& seconds, Work work) {
  const double start = now_seconds();
  auto result = work();
  seconds += now_seconds() - start;
  return result;
}

void answer_all(const Options& o, PointReader& points, PointAnswerer& answerer,
                AnswerWriter& writer, Account& account) {
  const std::string name = std::filesystem::path(o.points).filename().string();
  Progress progress("visibility of " + (name == "-" ? "standard input" : name),
                    o.always_progress ? ProgressWish::always : ProgressWish::on_terminal);
  PointBlock block;
  PointAnswers answers;
  for (double before = 0;;) {
    if (!timed(account.read, [&] { return points.next(block, o.block); })) return;
    const std::optional<double> after = points.share();
    const auto report = [&](double share) {
      if (after) progress.update(before + share * (*after - before));
    };
    account.counters.add(timed(
        account.answer, [&] { return answerer.answer(block, account.points, answers, report); }));
    const double start = now_seconds();
    writer.write(block, {answers.classes, answers.fractions});
    account.write += now_seconds() - start;
    account.points += block.positions.size();
    if (!after) progress.update(fmt::format("{} points", account.points));
    before = after.value_or(0);
  }
}

std::string stats_json(const Options& o, const Scene& scene, const Account& a) {
  const ShadowCounters& n = a.counters;
  const nlohmann::ordered_json json = {
      {"version", PENUMBRA_VERSION},
      {"scene", o.scene},
      {"points", a.points},
      {"lights", scene.lights.size()},
      {"method", name_of(o.answer.method)},
      {"shadow_samples", o.answer.shadow_samples},
      {"seed", o.answer.seed},
      {"threads", o.answer.threads},
      {"seconds",
       {{"load", a.load},
        {"build", a.build},
        {"read", a.read},
        {"answer", a.answer},
        {"write", a.write}}},
      {"rays", {{"shadow", n.rays}, {"shadow_set", n.set_rays}}},
      {"shadow_queries", {{"lit", n.lit}, {"penumbra", n.penumbra}, {"umbra", n.umbra}}},
      {"cache_decided", n.cache_decided},
      {"memory_bytes", {{"geometry", a.memory_bytes}}},
      {"peak_rss_bytes", peak_rss_bytes()}};
  return json.dump(2) + "\n";
}

void print_summary(const Options& o, const Account& a, std::size_t lights) {
  const ShadowCounters& n = a.counters;
  const auto all = static_cast<double>(std::max<std::uint64_t>(1, n.lit + n.penumbra + n.umbra));
  const auto percent = [&](std::uint64_t part) { return 100 * static_cast<double>(part) / all; };
  fmt::print(stderr,
             "{}{} points, {} light{}, {:.1f} s; lit {:.0f} %, penumbra {:.0f} %, umbra {:.0f} %\n",
             o.output == "-" ? "" : "wrote " + o.output + ": ", a.points, lights,
             lights == 1 ? "" : "s", a.read + a.answer + a.write, percent(n.lit),
             percent(n.penumbra), percent(n.umbra));
}

int run(Options o) {
  o.scene = take_scene(o.wishes, o.scene, "SCENE", "a file, or the name of a built-in scene");
  finish(o.wishes);
  check(o);
  std::signal(SIGPIPE, SIG_IGN);  // whoever reads our output may leave: an error like others
  Account account;
  const Scene scene = timed(account.load, [&] { return load_asked_scene(o.scene, o.wishes); });
  name_lights(scene);
  PointReader points(o.points, o.input_format);
  const AnswerLayout layout = layout_of(o, scene, points.has_normals());
  o.answer.has_fractions = layout.has_fractions;
  AnswerWriter writer(o.output, layout);
  const RemoveOnSignal until_written(writer.file().temporary());
  const auto answerer =
      timed(account.build, [&] { return std::make_unique<PointAnswerer>(scene, o.answer); });
  account.memory_bytes = answerer->memory_bytes();
  answer_all(o, points, *answerer, writer, account);
  writer.finish();
  if (!o.stats.empty()) write_file(o.stats, stats_json(o, scene, account));
  print_summary(o, account, scene.lights.size());
  return 0;
}

}  // namespace

Command add_visibility(CLI::App& program) {
  CLI::App* app = program.add_subcommand("visibility", "Say what points see of a scene's lights");
  const auto options = std::make_shared<Options>();
  app->add_option("SCENE", options->scene, scene_argument_help);
  add_file_options(*app, *options);
  add_question_options(*app, *options);
  add_light_options(*app, options->wishes);
  add_read_options(*app, options->wishes.read);
  add_stream_options(*app, *options);
  app->footer(std::string(lights_help) + examples);
  return {app, [options] { return run(*options); }};
}

}  // namespace penumbra
