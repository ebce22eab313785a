// SPDX-License-Identifier: MIT
#include "scene_options.h"

#include <fmt/format.h>

#include <CLI/App.hpp>

#include <cstdio>
#include <limits>

#include "options.h"
#include "penumbra/scene_io/numbers.h"
#include "penumbra/scene_io/radiance_view.h"
#include "usage_error.h"

namespace penumbra {

const char* const lights_help =
    "Lights (numbers in scene units, each with an optional r g b at the end):\n"
    "  point x y z\n"
    "  sphere cx cy cz r\n"
    "  line ax ay az bx by bz            from a to b\n"
    "  rect cx cy cz ux uy uz vx vy vz   centre and half edges\n"
    "  disk cx cy cz nx ny nz r          n is its normal\n"
    "  polygon n x y z ...               n corners, convex, in order\n"
    "  mesh n x y z ...                  convex hull of n points\n"
    "  sun dx dy dz degrees              towards it; diameter\n"
    "All but suns may end in `beam ax ay az full none`: along an axis, full light up to the first\n"
    "angle from it (in degrees), none from the second on.\n\n";

void add_scene_options(CLI::App& command, SceneWishes& w) {
  using Text = const std::string&;
  const auto add = [&command](const char* name, const char* value, const char* help, auto parse) {
    add_parsed(command, name, value, help, parse)->group("Scene");
  };
  add("--from", "x,y,z", "Camera position",
      [&w](Text text) { w.complete.from = parse_vector(text); });
  add("--at", "x,y,z", "What it looks at", [&w](Text text) { w.complete.at = parse_vector(text); });
  add("--fov", "DEG", "Vertical field of view, in perspective",
      [&w](Text text) { w.complete.fov_deg = parse_number(text, 0.001, 179.999); });
  command.add_option("--view", w.view, "A view of Radiance's: a view file, or options like rvu's")
      ->type_name("FILE|OPTIONS")
      ->group("Scene");
  add("--ambient", "r,g,b", "Light from everywhere, without shadows: 0,0,0 is none",
      [&w](Text text) { w.complete.ambient = parse_color(text); });
  add("--background", "r,g,b", "Colour where nothing is hit",
      [&w](Text text) { w.complete.background = parse_color(text); });
  add_ground_options(command, w, GroundChoice::automatic);
  add_light_options(command, w);
  add_read_options(command, w.read);
}

void add_ground_options(CLI::App& command, SceneWishes& w, GroundChoice by_default) {
  w.complete.ground = by_default;
  const char* const help = by_default == GroundChoice::none
                               ? "A floor that blocks light (default none)"
                               : "A floor (default auto: under bare models)";
  using Text = const std::string&;
  add_parsed(command, "--up", "x,y,z", "Which way is up", [&w](Text text) {
    w.complete.up = parse_vector(text);
  })->group("Scene");
  add_parsed(command, "--ground", "auto|none|HEIGHT", help, [&w](Text text) {
    w.complete.ground = parse_ground(text);
  })->group("Scene");
}

void add_light_options(CLI::App& command, SceneWishes& w) {
  command
      .add_option("--light", w.light_words,
                  "Add a light, see below; the first one replaces the file's")
      ->type_name("SPEC")
      ->group("Scene");
  command.add_flag("--clear-glass", w.complete.clear_glass, "Transparent things cast no shadow")
      ->group("Shadows");
}

void add_light_radius_option(CLI::App& command, SceneWishes& w) {
  add_parsed(command, "--light-radius", "R",
             "Make point and ball lights balls of this radius; N% of the extent",
             [&w](const std::string& text) { w.complete.light_radius = parse_light_radius(text); })
      ->group("Shadows");
}

void add_ray_options(CLI::App& command, RenderOptions& o) {
  using Text = const std::string&;
  add_parsed(command, "--spp", "N", "Samples a pixel, for smooth edges (default 1)",
             [&o](Text text) {
               o.samples_per_pixel = static_cast<std::uint32_t>(parse_count(text, 1, 65536));
             });
  command.add_flag_callback(
      "--pixel-corners", [&o] { o.pixel_point = PixelPoint::corner; },
      "One ray goes through a pixel's upper left corner, as in the SPD, not its centre");
  add_parsed(command, "--depth", "N", "Longest path of mirrors and glass (default 5)",
             [&o](Text text) { o.depth = static_cast<std::uint32_t>(parse_count(text, 1, 64)); });
  add_seed_option(command, o.seed);
}

void add_seed_option(CLI::App& command, std::uint64_t& seed) {
  add_parsed(command, "--seed", "N", "Of the random numbers (default 0)",
             [&seed](const std::string& text) {
               seed = parse_count(text, 0, std::numeric_limits<std::uint64_t>::max());
             })
      ->group("Shadows");
}

void add_method_option(CLI::App& command, Method& method, const std::string& product) {
  add_parsed(
      command, "--method", "M",
      fmt::format("shaft (default), stochastic, offset, reduced, umbra (all the same {}), or hard",
                  product),
      [&method](const std::string& text) { method = parse_method(text); })
      ->group("Shadows");
}

void add_shadow_samples_option(CLI::App& command, std::uint32_t& shadow_samples) {
  add_parsed(command, "--shadow-samples", "D", "Samples a point and light (default 32)",
             [&shadow_samples](const std::string& text) {
               shadow_samples = static_cast<std::uint32_t>(parse_count(text, 1, 65536));
             })
      ->group("Shadows");
}

void add_run_options(CLI::App& command, std::uint32_t& threads, std::string& stats,
                     bool& always_progress) {
  add_parsed(command, "--threads", "N", "0 (default) takes all",
             [&threads](const std::string& text) {
               threads = static_cast<std::uint32_t>(parse_count(text, 0, 1024));
             })
      ->group("Run");
  command.add_option("--stats", stats, "Write counters, times and memory as JSON")
      ->type_name("FILE")
      ->group("Run");
  command.add_flag("--progress", always_progress, "Show progress even where stderr is no terminal")
      ->group("Run");
}

void take_back_scenes(SceneWishes& wishes, std::vector<std::string>& scenes) {
  std::vector<std::string>& words = wishes.light_words;
  if (!scenes.empty()) return;
  const auto may_be_scene = [&](const std::string& word) {
    const bool is_quoted_light = word.find(' ') != word.npos && !scenes.empty();
    return !parse_double(word) && !is_quoted_light;
  };
  while (words.size() > 1 && may_be_scene(words.back())) {
    scenes.insert(scenes.begin(), words.back());
    words.pop_back();
  }
}

std::string take_scene(SceneWishes& wishes, const std::string& given, const std::string& name,
                       const std::string& what) {
  std::vector<std::string> scenes;
  if (!given.empty()) scenes.push_back(given);
  take_back_scenes(wishes, scenes);
  if (scenes.empty()) throw UsageError(name + " is missing: " + what);
  if (scenes.size() > 1) throw UsageError(scenes[1] + ": one " + name + " at a time");
  return scenes.front();
}

namespace {

Camera parse_view(const std::string& text) {
  try {
    const RadianceView view = parse_radiance_view(text);
    if (!view.warning.empty()) fmt::print(stderr, "warning: --view: {}\n", view.warning);
    return view.camera;
  } catch (const Error& error) {
    if (!error.place.file.empty()) throw;
    throw UsageError("--view: " + error.problem + "; " + error.hint);
  }
}

}  // namespace

void finish(SceneWishes& w) {
  if (!w.view.empty()) w.complete.camera = parse_view(w.view);
  w.complete.lights = parse_lights(w.light_words);
  if (w.complete.from && w.complete.at && *w.complete.from == *w.complete.at)
    throw UsageError("--from and --at are the same point");
  if (w.complete.up && *w.complete.up == Vec3d{}) throw UsageError("--up 0,0,0 is no direction");
}

}  // namespace penumbra
