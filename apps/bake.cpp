// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <CLI/App.hpp>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <memory>
#include <utility>

#include "asked_scene.h"
#include "bake_files.h"
#include "bake_report.h"
#include "commands.h"
#include "deferred_signals.h"
#include "options.h"
#include "output_files.h"
#include "penumbra/scene/error.h"
#include "penumbra/scene_io/write_scene.h"
#include "penumbra/trace/prepare.h"
#include "progress.h"
#include "resources.h"
#include "scene_options.h"
#include "usage_error.h"

namespace penumbra {
namespace {

struct Options {
  std::string scene, stats, mesh;
  BakeOutput output;
  SceneWishes wishes;
  BakeOptions bake;
  Method method = Method::shaft;
  UvChoice uv_set = UvChoice::automatic;
  bool per_mesh = false, always_progress = false;
};

void add_texture_options(CLI::App& app, Options& o) {
  using Text = const std::string&;
  const auto add = [&app](const char* name, const char* value, const char* help, auto parse) {
    add_parsed(app, name, value, help, parse)->group("Texture");
  };
  const auto number = [](std::uint32_t& to, std::uint64_t least, std::uint64_t most) {
    return [&to, least, most](Text text) {
      to = static_cast<std::uint32_t>(parse_count(text, least, most));
    };
  };
  add("-o,--output", "FILE", "The texture, .exr or .png (grey; one file a light)", [&o](Text text) {
    o.output.path = parse_output(text, {".png", ".exr"});
  });
  add("--size", "WxH", "Texels (default 1024x1024)", [&o](Text text) {
    const PixelSize size = parse_size(text);
    o.bake.width = size.width, o.bake.height = size.height;
  });
  add("--padding", "N", "Texels around charts that repeat the nearest (default 8)",
      number(o.bake.padding, 0, 1024));
  add("--texel-samples", "N", "Points of a texel that is not proven (default 4)",
      number(o.bake.texel_samples, 1, 1024));
  add("--weight", "W",
      "none (default): the share of the light's samples that is seen; cosine: of those above the "
      "surface's horizon, by their cosine, as shaders need it",
      [&o](Text text) { o.bake.value = parse_bake_value(text); });
  add("--channel", "C", "per-light (default), or mean: of all lights",
      [&o](Text text) { o.output.channel = parse_bake_channel(text); });
  add("--layers", "LIST", "EXR layers beside: any of class,coverage",
      [&o](Text text) { parse_bake_layers(text, o.output); });
  add("--bits", "8|16", "Of a PNG (default 8)",
      [&o](Text text) { o.output.png.bits = parse_bits(text); });
  app.add_flag("--srgb", o.output.png.is_srgb,
               "Store PNG as sRGB codes, for use as a colour; else as plain values")
      ->group("Texture");
  add("--uv-set", "auto|1|2", "Texture coordinates (default auto: the second set, if there is one)",
      [&o](Text text) { o.uv_set = parse_uv_set(text); });
  app.add_flag("--per-mesh", o.per_mesh, "A texture for each mesh, its name in the file's")
      ->group("Texture");
  app.add_option("--mesh", o.mesh, "Bake this one alone; a wrong name lists them")
      ->type_name("NAME|INDEX")
      ->group("Texture");
}

void add_shadow_options(CLI::App& app, Options& o) {
  add_method_option(app, o.method, "texture");
  add_shadow_samples_option(app, o.bake.shadow_samples);
  add_seed_option(app, o.bake.seed);
  add_light_radius_option(app, o.wishes);
}

constexpr const char* about =
    "Bakes how much of each light a mesh's surface sees, 0 to 1, into textures. The mesh needs\n"
    "texture coordinates (UVs) that give each triangle a place of its own: Blender's Lightmap "
    "Pack\n"
    "or Smart UV Project make them, or xatlas. Lights are the file's own or those of --light; "
    "nothing\n"
    "is added, unless --ground says so.";

constexpr const char* examples =
    "The texture fits the mesh as its file has it: in glTF, whose v grows downwards, and in the\n"
    "others, whose v grows upwards.\n\n"
    "Examples:\n"
    "  penumbra bake room.glb -o lightmap.exr --light sphere 0 3 0 0.2\n"
    "  penumbra bake statue.obj -o shadow.png --light sun 1 2 1 0.53 --ground auto --bits 16\n"
    "  penumbra bake level.glb -o shadow.png --per-mesh --size 512x512\n"
    "  penumbra bake room.glb -o lightmap.exr --layers class,coverage --shadow-samples 256\n";

/// Checks what no single option can.
void check(const Options& o) {
  if (o.output.path.empty()) throw UsageError("-o FILE is missing: where should the texture go?");
  const bool is_png = has_extension(o.output.path, ".png");
  if (is_png && (o.output.has_classes || o.output.has_coverage))
    throw UsageError("--layers needs an .exr file; a PNG holds one light alone");
  if (!is_png && (o.output.png.bits != 8 || o.output.png.is_srgb))
    throw UsageError("--bits and --srgb are for .png; an .exr holds floats");
  if (o.output.png.bits == 16 && o.output.png.is_srgb)
    throw UsageError("--srgb is for 8 bits, --bits 16 for plain values; choose one");
  if (o.per_mesh && !o.mesh.empty())
    throw UsageError("--mesh bakes one mesh, --per-mesh all of them; choose one");
}

/// The object of that name, or number.
const BakeObject& find_object(const Options& o, const std::vector<BakeObject>& objects) {
  for (const BakeObject& object : objects)
    if (object.name == o.mesh) return object;
  std::size_t index = 0;
  const char* end = o.mesh.data() + o.mesh.size();
  const auto [stop, error] = std::from_chars(o.mesh.data(), end, index);
  if (error == std::errc() && stop == end && index < objects.size()) return objects[index];
  constexpr std::size_t most_listed = 20;
  std::string names;
  for (std::size_t i = 0; i < std::min(objects.size(), most_listed); ++i)
    names += fmt::format("{}{} {}", i > 0 ? ", " : "", i,
                         objects[i].name.empty() ? "(no name)" : objects[i].name);
  throw Error({o.scene, {}, {}}, "there is no mesh " + o.mesh + " that can be baked",
              fmt::format("use a name or a number of: {}{}", names,
                          objects.size() > most_listed ? ", ..." : ""));
}

/// Meshes that share a texture, and where it goes.
struct Texture {
  std::vector<std::uint32_t> meshes;
  BakeOutput output;
};

std::vector<Texture> plan(const Options& o, const BakeObjects& found) {
  if (!o.mesh.empty()) return {{find_object(o, found.objects).meshes, o.output}};
  if (!o.per_mesh) {
    Texture all{{}, o.output};
    for (const BakeObject& object : found.objects)
      all.meshes.insert(all.meshes.end(), object.meshes.begin(), object.meshes.end());
    return {all};
  }
  std::vector<Texture> textures;
  const std::vector<BakeOutput> outputs = outputs_of(o.output, found.objects);
  for (std::size_t i = 0; i < outputs.size(); ++i)
    textures.push_back({found.objects[i].meshes, outputs[i]});
  return textures;
}

/// Before hours of work.
void check_files(const Options& o, const std::vector<Texture>& textures, std::size_t lights) {
  check_files_differ(o.scene, o.stats);
  if (!o.stats.empty()) check_output_path(o.stats);
  for (const Texture& texture : textures)
    for (const std::string& file : files_of(texture.output, lights)) {
      check_files_differ(o.scene, file);
      check_files_differ(o.stats, file);
      check_image_path(file);
    }
}

void print_warnings(const std::string& scene, const std::vector<std::string>& lines) {
  for (const std::string& line : lines) fmt::print(stderr, "warning: {}: {}\n", scene, line);
}

/// Bakes and writes all of them.
void bake_all(const Options& o, const Scene& scene, const ShadowScene& shadows, UvSet set,
              const std::vector<Texture>& textures, BakeReport& report) {
  Progress progress("baking " + without_folders(o.scene),
                    o.always_progress ? ProgressWish::always : ProgressWish::on_terminal);
  const double count = static_cast<double>(textures.size());
  for (std::size_t i = 0; i < textures.size(); ++i) {
    const UvAtlas atlas = make_atlas(scene, textures[i].meshes, set, o.bake.width, o.bake.height);
    BakeOptions options = o.bake;
    options.progress = [&](double share) {
      progress.update((static_cast<double>(i) + share) / count);
    };
    Bake baked = bake(scene, shadows, atlas, options);
    report.counters.add(baked.counters);
    report.faults.add(atlas.faults);
    report.triangles += atlas.triangle_count;
    report.threads = baked.threads;
    report.bake_seconds += baked.seconds;
    add_metadata(report, baked.image);
    const DeferredSignals until_written;
    write_bake(textures[i].output, std::move(baked.image), report.lights);
    for (std::string& file : files_of(textures[i].output, report.lights))
      report.files.push_back(std::move(file));
  }
}

int run(Options o, const std::vector<std::string>& arguments) {
  o.scene = take_scene(o.wishes, o.scene, "MODEL", "a file with a mesh and its UVs");
  finish(o.wishes);
  check(o);
  BakeReport report;
  report.scene = o.scene, report.arguments = arguments;
  o.bake.has_classes = o.output.has_classes;
  report.options = o.bake, report.method = o.method;
  const double start = now_seconds();
  const Scene scene = load_asked_scene(o.scene, o.wishes);
  const BakeObjects found = bake_objects(scene, o.uv_set);
  const std::vector<Texture> textures = plan(o, found);
  report.set = found.set, report.lights = scene.lights.size();
  check_files(o, textures, report.lights);
  name_lights(scene);
  print_warnings(o.scene, warnings_of(found));
  const double loaded = now_seconds();
  const Kernel kernel(scene.shapes, kernel_options(scene));
  const ShadowScene shadows = prepare_shadows(scene, kernel, o.method);
  report.load_seconds = loaded - start, report.build_seconds = now_seconds() - loaded;
  bake_all(o, scene, shadows, found.set, textures, report);
  print_warnings(o.scene, warnings_of(report, textures.front().meshes.size() > 1 && !o.per_mesh));
  if (!o.stats.empty()) write_file(o.stats, stats_json(report));
  fmt::print(stderr, "{}\n", summary(report));
  return 0;
}

}  // namespace

Command add_bake(CLI::App& program, const std::vector<std::string>& arguments) {
  CLI::App* app = program.add_subcommand("bake", "Bake shadows into a mesh's textures");
  const auto options = std::make_shared<Options>();
  app->add_option("MODEL", options->scene,
                  "A file with a mesh that has texture coordinates (glTF, OBJ, PLY, ...)");
  add_texture_options(*app, *options);
  add_shadow_options(*app, *options);
  add_ground_options(*app, options->wishes, GroundChoice::none);
  add_light_options(*app, options->wishes);
  add_run_options(*app, options->bake.threads, options->stats, options->always_progress);
  app->footer(std::string(about) + "\n\n" + lights_help + examples);
  return {app, [options, arguments] { return run(*options, arguments); }};
}

}  // namespace penumbra
