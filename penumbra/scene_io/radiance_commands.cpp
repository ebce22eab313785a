// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/radiance_commands.h"

#include <utility>

#include <fmt/format.h>

#include "penumbra/scene_io/numbers.h"

namespace penumbra {

std::vector<std::vector<std::string>> split_radiance_command(std::string_view command,
                                                             const Error::Place& place) {
  std::vector<std::vector<std::string>> programs(1);
  std::string word;
  bool in_word = false;
  const auto end_word = [&] {
    if (in_word) programs.back().push_back(std::exchange(word, {}));
    in_word = false;
  };
  for (std::size_t i = 0; i < command.size(); ++i) {
    const char c = command[i];
    if (c == ' ' || c == '\t' || c == '\f' || c == '\v') {
      end_word();
    } else if (c == '#' && !in_word) {
      break;
    } else if (c == '|') {
      end_word();
      programs.emplace_back();
    } else if (c == '"' || c == '\'') {
      const std::size_t end = command.find(c, i + 1);
      if (end == std::string_view::npos)
        throw Error(place, "a quote in a command does not end", "close it");
      word += command.substr(i + 1, end - i - 1);
      in_word = true;
      i = end;
    } else if (std::string_view(";&<>$`()\\*?[]{}").find(c) != std::string_view::npos) {
      throw Error(place, fmt::format("the command uses the shell's '{}'", c),
                  "commands are not run: expand it first, as in `xform -e scene.rad > all.rad`, "
                  "and render all.rad");
    } else {
      word += c;
      in_word = true;
    }
  }
  end_word();
  for (const std::vector<std::string>& program : programs)
    if (program.empty()) throw Error(place, "a command is empty", "remove the line");
  return programs;
}

void refuse_radiance_command(std::string_view program, const Error::Place& place) {
  throw Error(place, fmt::format("the command {} is not run", in_quotes(program)),
              "only xform, cat and genbox are read: expand it first, as in `xform -e scene.rad > "
              "all.rad`, and render all.rad");
}

}  // namespace penumbra
