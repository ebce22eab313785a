// SPDX-License-Identifier: MIT
// Ctrl-C while a file is being written waits until it is whole.
#pragma once

#include <optional>

#include "signal_handler.h"

namespace penumbra {

/// While one lives, SIGINT, SIGTERM and SIGHUP are kept; its end delivers what came. One at a time.
class DeferredSignals {
 public:
  DeferredSignals();
  ~DeferredSignals();
  DeferredSignals(const DeferredSignals&) = delete;
  DeferredSignals& operator=(const DeferredSignals&) = delete;

 private:
  std::optional<SignalHandler> handler_;
};

}  // namespace penumbra
