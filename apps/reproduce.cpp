// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <CLI/App.hpp>

#include <filesystem>
#include <memory>
#include <system_error>

#include "commands.h"
#include "penumbra/scene/error.h"
#include "progress.h"
#include "reproduce/measure.h"

namespace penumbra {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string output = "reproduction", molecule, bust;
  bool is_quick = false, always_progress = false;
};

int run(const Options& o) {
  std::error_code error;
  fs::create_directories(o.output, error);
  if (error)
    throw Error({o.output, {}, {}}, "cannot be made a folder: " + error.message(),
                "choose another with -o");
  const reproduce::Plan plan = reproduce::make_plan(o.is_quick, o.molecule, o.bust);
  reproduce::Journal journal(fs::path(o.output) / "measurements.csv", this_machine(),
                             name_of(plan));
  {
    Progress progress("measuring",
                      o.always_progress ? ProgressWish::always : ProgressWish::on_terminal);
    measure_all(plan, journal, [&](double share, const std::string&) { progress.update(share); });
  }
  return 0;
}

}  // namespace

Command add_reproduce(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "reproduce", "Repeat the paper's evaluation on this machine, and write a page about it");
  const auto options = std::make_shared<Options>();
  app->add_option("-o,--output", options->output, "Folder (default: reproduction)")
      ->type_name("DIR");
  app->add_flag("--quick", options->is_quick, "Fewer points and rounds: under 3 minutes");
  app->add_option("--molecule", options->molecule, "A molecule instead of the built-in one")
      ->type_name("FILE");
  app->add_option("--bust", options->bust, "A mesh instead of the built-in one")->type_name("FILE");
  app->add_flag("--progress", options->always_progress,
                "Show progress even where stderr is no terminal");
  return {app, [options] { return run(*options); }};
}

}  // namespace penumbra
