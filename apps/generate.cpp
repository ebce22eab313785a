// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <CLI/App.hpp>

#include <cstdio>
#include <memory>

#include "commands.h"
#include "deferred_signals.h"
#include "options.h"
#include "penumbra/scene/gallery.h"
#include "penumbra/scene_io/write_scene.h"
#include "scene_argument.h"

namespace penumbra {
namespace {

struct GenerateOptions {
  std::string name, output;
};

int run(const GenerateOptions& options) {
  const Scene scene = load_built_in_scene(options.name);
  {
    const DeferredSignals until_written;
    write_scene(options.output, scene);
  }
  fmt::print(stderr, "wrote {}: from a scene of {} primitives and {} lights\n", options.output,
             primitive_count(scene.shapes), scene.lights.size());
  return 0;
}

std::string footer() {
  std::string text = "Built-in scenes:\n";
  for (const GalleryEntry& entry : gallery_help())
    text += fmt::format("  {:<12} {}\n", entry.name, entry.description);
  return text +
         "\nPLY holds triangle meshes alone; NFF holds all built-in scenes.\n\n"
         "Example:\n"
         "  penumbra generate balls:4 -o balls.nff\n";
}

}  // namespace

Command add_generate(CLI::App& program) {
  CLI::App* app = program.add_subcommand("generate", "Write a built-in scene to a file");
  const auto options = std::make_shared<GenerateOptions>();
  app->add_option("NAME", options->name, "A built-in scene, see below")->required();
  add_parsed(*app, "-o,--output", "FILE", "Where to, .nff or .ply",
             [options](const std::string& text) {
               options->output = parse_output(text, {".nff", ".ply"});
             })
      ->required();
  app->footer(footer);
  return {app, [options] { return run(*options); }};
}

}  // namespace penumbra
