// SPDX-License-Identifier: MIT
#include "output_files.h"

#include <filesystem>

namespace penumbra {

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
