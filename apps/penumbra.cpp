// SPDX-License-Identifier: MIT
// The program: finds the command, runs it, and turns what went wrong into a message and an exit
// code: 1 bad input, 2 bad usage.
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "commands.h"
#include "penumbra/scene/error.h"
#include "penumbra/version.h"
#include "usage_error.h"

namespace penumbra {
namespace {

constexpr int bad_input = 1, bad_usage = 2;

/// "-.5" is a number, which CLI11 would take for an option; "-0.5" it takes for a number.
std::string with_leading_zero(std::string argument) {
  if (argument.size() > 2 && argument.starts_with("-.") &&
      std::isdigit(static_cast<unsigned char>(argument[2])))
    argument.insert(1, "0");
  return argument;
}

/// Of the commands, the one that was given; nullptr when none was.
const Command* chosen(const std::vector<Command>& commands) {
  for (const Command& command : commands)
    if (command.app->parsed()) return &command;
  return nullptr;
}

int report_usage(const Command* command, const std::string& what) {
  const std::string name = command ? "penumbra " + command->app->get_name() : "penumbra";
  fmt::print(stderr, "{}: {}; see '{} --help'\n", name, what, name);
  return bad_usage;
}

int run(const Command& command) {
  try {
    const int code = command.run();
    // A full disk behind a redirected stdout shows no earlier than here.
    if (std::fflush(stdout) != 0) throw Error({}, "cannot write to the standard output");
    return code;
  } catch (const UsageError& error) {
    return report_usage(&command, error.what());
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "out of memory; try a smaller picture or scene\n");
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
  }
  return command.input_error;
}

int main_with(const std::vector<std::string>& arguments) {
  CLI::App program{"Soft shadows: a scene goes in, a picture comes out.", "penumbra"};
  program.set_version_flag("--version", "penumbra " PENUMBRA_VERSION);
  program.require_subcommand(1);
  program.get_formatter()->column_width(28);
  program.footer(
      "Examples:\n"
      "  penumbra render bust.ply -o bust.png\n"
      "  penumbra render balls:4 -o balls.png --shadow-samples 64 --light-radius 5%\n"
      "  penumbra info molecule.pdb\n");
  const std::vector<Command> commands = {
<<<<<<< HEAD
      add_render(program, arguments), add_bake(program, arguments), add_info(program),
      add_generate(program),          add_compare(program),         add_bench(program),
      add_reproduce(program),         add_visibility(program)};
=======
      add_render(program, arguments), add_info(program),       add_generate(program),
      add_compare(program),           add_bench(program),      add_reproduce(program),
      add_visibility(program),        add_completion(program), add_complete(program),
      add_manual(program)};
>>>>>>> pack
  try {
    std::vector<std::string> backwards(arguments.rbegin(), std::prev(arguments.rend()));
    std::transform(backwards.begin(), backwards.end(), backwards.begin(), with_leading_zero);
    program.parse(std::move(backwards));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program.exit(error);  // --help, --version
    if (const std::vector<std::string> unknown = program.remaining();
        !chosen(commands) && !unknown.empty())
      return report_usage(nullptr, "there is no command " + unknown.front());
    return report_usage(chosen(commands), error.what());
  } catch (const UsageError& error) {
    return report_usage(chosen(commands), error.what());
  }
  return run(*chosen(commands));
}

}  // namespace
}  // namespace penumbra

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file size limit is a write error, reported like any other
  try {
    return penumbra::main_with({argv, argv + argc});
  } catch (const std::exception& error) {
    fmt::print(stderr, "penumbra: {}\n", error.what());
    return penumbra::bad_input;
  }
}
