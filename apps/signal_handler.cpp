// SPDX-License-Identifier: MIT
#include "signal_handler.h"

#include <csignal>

namespace penumbra {
namespace {

constexpr std::array<int, 3> handled = {SIGINT, SIGTERM, SIGHUP};

}  // namespace

SignalHandler::SignalHandler(void (*handle)(int)) {
  for (std::size_t i = 0; i < handled.size(); ++i) {
    earlier_[i] = std::signal(handled[i], handle);
    if (earlier_[i] == SIG_IGN) std::signal(handled[i], SIG_IGN);
  }
}

SignalHandler::~SignalHandler() {
  for (std::size_t i = 0; i < handled.size(); ++i) std::signal(handled[i], earlier_[i]);
}

}  // namespace penumbra
