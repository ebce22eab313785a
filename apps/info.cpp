// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <CLI/App.hpp>

#include <cstdio>
#include <memory>

#include "commands.h"
#include "options.h"
#include "penumbra/kernel/kernel.h"
#include "penumbra/trace/prepare.h"
#include "resources.h"
#include "scene_argument.h"
#include "scene_facts.h"

namespace penumbra {
namespace {

struct InfoOptions {
  std::string scene;
  ReadOptions read;
  bool json = false;
};

int run(const InfoOptions& options) {
  const double start = now_seconds();
  const Scene scene = load_scene(options.scene, options.read);
  const double loaded = now_seconds();
  const Kernel kernel(scene.shapes, kernel_options(scene));
  SceneFacts facts = scene_facts(scene);
  facts.load_seconds = loaded - start;
  facts.build_seconds = now_seconds() - loaded;
  facts.memory_bytes = kernel.memory_bytes();
  facts.peak_rss_bytes = peak_rss_bytes();
  fmt::print("{}", options.json ? to_json(facts, scene) : to_text(facts, scene));
  return 0;
}

}  // namespace

Command add_info(CLI::App& program) {
  CLI::App* app = program.add_subcommand("info", "Say what is in a scene");
  const auto options = std::make_shared<InfoOptions>();
  app->add_option("SCENE", options->scene, scene_argument_help)->required();
  app->add_flag("--json", options->json, "Print JSON");
  add_read_options(*app, options->read);
  app->footer(
      "Example:\n"
      "  penumbra info bust.ply --json\n");
  return {app, [options] { return run(*options); }};
}

}  // namespace penumbra
