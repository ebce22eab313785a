// SPDX-License-Identifier: MIT
#include "remove_on_signal.h"

#include <unistd.h>

#include <array>
#include <csignal>
#include <string>

namespace penumbra {
namespace {

std::array<char, 4096> file_name{};  // a handler can reach nothing but globals

void remove_and_end(int signal) {
  if (file_name[0] != '\0') unlink(file_name.data());
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

RemoveOnSignal::RemoveOnSignal(const std::filesystem::path& path) {
  const std::string name = path.string();
  if (name.size() < file_name.size()) name.copy(file_name.data(), name.size());
  handler_.emplace(remove_and_end);
}

RemoveOnSignal::~RemoveOnSignal() {
  handler_.reset();
  file_name.fill('\0');
}

}  // namespace penumbra
