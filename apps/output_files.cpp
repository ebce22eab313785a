// SPDX-License-Identifier: MIT
#include "output_files.h"

#include <fmt/format.h>

#include <filesystem>

#include "usage_error.h"

namespace penumbra {

void check_files_differ(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return;
  std::error_code ignored;
  const auto same = std::filesystem::weakly_canonical(a, ignored) ==
                    std::filesystem::weakly_canonical(b, ignored);
  if (same || std::filesystem::equivalent(a, b, ignored))
    throw UsageError(
        fmt::format("{} and {} are the same file; give the output another name", a, b));
}

std::string with_suffix(const std::string& path, std::string_view suffix) {
  std::filesystem::path p(path);
  std::string name = p.stem().string();
  name += suffix;
  return p.replace_filename(name + p.extension().string()).string();
}

std::string without_folders(const std::string& argument) {
  if (argument.find('/') == argument.npos) return argument;
  return std::filesystem::path(argument).filename().string();
}

std::string command_text(const std::vector<std::string>& arguments) {
  std::string command;
  for (const std::string& argument : arguments) {
    if (!command.empty()) command += ' ';
    command += without_folders(argument);
  }
  return command;
}

}  // namespace penumbra
