// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <CLI/App.hpp>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "commands.h"
#include "penumbra/scene/error.h"
#include "penumbra/scene_io/image_io.h"
#include "penumbra/scene_io/write_scene.h"
#include "progress.h"
#include "reproduce/evaluation.h"
#include "reproduce/gnuplot.h"
#include "reproduce/measure.h"
#include "reproduce/page.h"
#include "reproduce/pictures.h"
#include "reproduce/plots.h"
#include "reproduce/tables_text.h"

namespace penumbra {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string output = "reproduction", molecule, bust;
  bool is_quick = false, is_smoke = false, always_progress = false;
};

/// Writes the page and all that it links to but the pictures.
void write_report(const reproduce::Report& report, const fs::path& folder) {
  std::map<std::string, std::string> svg_by_plot_id;
  for (const reproduce::Section& section : report.sections) {
    for (const reproduce::Table& table : section.tables)
      write_file(folder / (table.id + ".csv"), to_csv(table));
    for (const reproduce::Plot& plot : section.plots) {
      reproduce::PlotFiles files = draw(plot);
      write_file(folder / (plot.id + ".csv"), to_csv(plot));
      write_file(folder / (plot.id + ".svg"), files.svg);
      write_file(folder / (plot.id + ".png"), files.png);
      svg_by_plot_id[plot.id] = std::move(files.svg);
    }
  }
  write_file(folder / "tables.md", to_markdown(report));
  write_file(folder / "index.html", to_html(report, svg_by_plot_id));
}

reproduce::Effort effort_of(const Options& o) {
  if (o.is_smoke) return reproduce::Effort::smoke;
  return o.is_quick ? reproduce::Effort::quick : reproduce::Effort::full;
}

int run(const Options& o) {
  reproduce::check_gnuplot();
  const reproduce::Plan plan = reproduce::make_plan(effort_of(o), o.molecule, o.bust);
  reproduce::Scenes scenes(plan);
  const fs::path folder = o.output;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw Error({o.output, {}, {}}, "cannot be made a folder: " + error.message(),
                "choose another with -o");
  check_output_path(folder / "index.html");

  const Machine machine = this_machine();
  reproduce::Journal journal(folder / "measurements.csv", machine, name_of(plan));
  const auto is_of_another_build = [&](const reproduce::Measurement& m) {
    return m.program != machine.program;
  };
  if (std::any_of(journal.all().begin(), journal.all().end(), is_of_another_build))
    fmt::print(stderr,
               "{}: some rows were measured by another build of this version; remove the file to "
               "measure all anew\n",
               (folder / "measurements.csv").string());
  const auto wish = o.always_progress ? ProgressWish::always : ProgressWish::on_terminal;
  {
    Progress progress("measuring", wish);
    measure_all(plan, scenes, journal, [&](double share) { progress.update(share); });
  }
  std::vector<reproduce::Gallery> pictures;
  {
    Progress progress("drawing", wish);
    pictures = draw_pictures(plan, scenes, folder, [&](double share) { progress.update(share); });
  }
  write_report(evaluate({plan, journal}, machine, std::move(pictures)), folder);
  fmt::print("{}\n", (folder / "index.html").string());
  return 0;
}

}  // namespace

Command add_reproduce(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "reproduce", "Repeat the paper's evaluation on this machine, and write a page about it");
  const auto options = std::make_shared<Options>();
  app->add_option("-o,--output", options->output, "Folder (default: reproduction)")
      ->type_name("DIR");
  CLI::Option* quick = app->add_flag("--quick", options->is_quick,
                                     "Fewer points and rounds, smaller pictures: under 3 minutes");
  app->add_flag("--smoke", options->is_smoke,
                "Hardly any, to see that everything works: seconds; its figures mean nothing")
      ->excludes(quick);
  app->add_option("--molecule", options->molecule, "A molecule instead of the built-in one")
      ->type_name("FILE");
  app->add_option("--bust", options->bust, "A mesh instead of the built-in one")->type_name("FILE");
  app->add_flag("--progress", options->always_progress,
                "Show progress even where stderr is no terminal");
  app->footer(
      "Measures Tables 1 to 4 and Figures 6 to 8 of Formella and Lukaszewski (WSCG 1998), draws "
      "its\n"
      "Figures 9 to 13, and more of our own beside them. In the folder: index.html, a page that "
      "needs\n"
      "nothing else; measurements.csv, every number with its machine, compiler and date; each "
      "table and\n"
      "plot as CSV, plots as SVG and PNG, pictures as PNG; tables.md. The whole takes some 20 "
      "minutes;\n"
      "an interrupted run goes on where it was. Times mean something on a quiet machine alone.\n"
      "Plots are drawn by gnuplot.\n\n"
      "Examples:\n"
      "  penumbra reproduce -o reproduction\n"
      "  penumbra reproduce --quick --bust scan.ply --molecule 1hpv.pdb -o mine\n");
  return {app, [options] { return run(*options); }};
}

}  // namespace penumbra
