// SPDX-License-Identifier: MIT
// The program's commands, one file each.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;  // the library takes long to compile
}

namespace penumbra {

/// A command of the program: its options are parsed into state that `run` owns. `run` returns the
/// exit code and throws Error or UsageError.
struct Command {
  CLI::App* app = nullptr;
  std::function<int()> run;
  int input_error = 1;  ///< exit code for an input that is wrong
};

/// `arguments`: the whole command line, for pictures to say how they were made.
Command add_render(CLI::App& program, const std::vector<std::string>& arguments);
Command add_bake(CLI::App& program, const std::vector<std::string>& arguments);
Command add_info(CLI::App& program);
Command add_generate(CLI::App& program);
Command add_compare(CLI::App& program);
Command add_bench(CLI::App& program);
Command add_reproduce(CLI::App& program);
Command add_visibility(CLI::App& program);
Command add_completion(CLI::App& program);
/// For shells and the build, not in the help: what may be typed next, and the manual pages.
Command add_complete(CLI::App& program);
Command add_manual(CLI::App& program);

}  // namespace penumbra
