// SPDX-License-Identifier: MIT
#include "deferred_signals.h"

#include <csignal>

namespace penumbra {
namespace {

volatile std::sig_atomic_t received = 0;  // a handler can reach nothing but globals

void keep(int signal) { received = signal; }

}  // namespace

DeferredSignals::DeferredSignals() {
  received = 0;
  handler_.emplace(keep);
}

DeferredSignals::~DeferredSignals() {
  handler_.reset();
  if (received != 0) std::raise(received);
}

}  // namespace penumbra
