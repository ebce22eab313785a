// SPDX-License-Identifier: MIT
#include "deferred_signals.h"

#include <array>
#include <csignal>

namespace penumbra {
namespace {

constexpr std::array<int, 3> kept_signals = {SIGINT, SIGTERM, SIGHUP};

// A handler can reach nothing but globals.
volatile std::sig_atomic_t received = 0;
std::array<void (*)(int), kept_signals.size()> earlier_handlers{};

void keep(int signal) { received = signal; }

}  // namespace

DeferredSignals::DeferredSignals() {
  received = 0;
  for (std::size_t i = 0; i < kept_signals.size(); ++i) {
    earlier_handlers[i] = std::signal(kept_signals[i], keep);
    // What the caller had ignored (nohup) stays ignored.
    if (earlier_handlers[i] == SIG_IGN) std::signal(kept_signals[i], SIG_IGN);
  }
}

DeferredSignals::~DeferredSignals() {
  for (std::size_t i = 0; i < kept_signals.size(); ++i)
    std::signal(kept_signals[i], earlier_handlers[i]);
  if (received != 0) std::raise(received);
}

}  // namespace penumbra
