// SPDX-License-Identifier: MIT
#include "remove_on_signal.h"

#include <unistd.h>

#include <array>
#include <csignal>
#include <string>

namespace penumbra {
namespace {

constexpr std::array<int, 3> caught_signals = {SIGINT, SIGTERM, SIGHUP};

// A handler can reach nothing but globals.
std::array<char, 4096> file_name{};
std::array<void (*)(int), caught_signals.size()> earlier_handlers{};

void remove_and_end(int signal) {
  if (file_name[0] != '\0') unlink(file_name.data());
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

RemoveOnSignal::RemoveOnSignal(const std::filesystem::path& path) {
  const std::string name = path.string();
  if (name.size() < file_name.size()) name.copy(file_name.data(), name.size());
  for (std::size_t i = 0; i < caught_signals.size(); ++i) {
    earlier_handlers[i] = std::signal(caught_signals[i], remove_and_end);
    // What the caller had ignored (nohup) stays ignored.
    if (earlier_handlers[i] == SIG_IGN) std::signal(caught_signals[i], SIG_IGN);
  }
}

RemoveOnSignal::~RemoveOnSignal() {
  for (std::size_t i = 0; i < caught_signals.size(); ++i)
    std::signal(caught_signals[i], earlier_handlers[i]);
  file_name.fill('\0');
}

}  // namespace penumbra
