// SPDX-License-Identifier: MIT
// Ctrl-C and its like, for as long as something must not be cut short.
#pragma once

#include <array>

namespace penumbra {

/// While it lives, SIGINT, SIGTERM and SIGHUP are handled by this function; those that the caller
/// had ignored (nohup) stay ignored.
class SignalHandler {
 public:
  explicit SignalHandler(void (*handle)(int));
  ~SignalHandler();
  SignalHandler(const SignalHandler&) = delete;
  SignalHandler& operator=(const SignalHandler&) = delete;

 private:
  std::array<void (*)(int), 3> earlier_{};
};

}  // namespace penumbra
