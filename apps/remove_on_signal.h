// SPDX-License-Identifier: MIT
// A long run that is interrupted leaves no half-written file behind.
#pragma once

#include <filesystem>
#include <optional>

#include "signal_handler.h"

namespace penumbra {

/// While it lives, Ctrl-C and its like remove a file before they end the program. One at a time.
class RemoveOnSignal {
 public:
  /// An empty path: nothing is removed.
  explicit RemoveOnSignal(const std::filesystem::path& path);
  ~RemoveOnSignal();
  RemoveOnSignal(const RemoveOnSignal&) = delete;
  RemoveOnSignal& operator=(const RemoveOnSignal&) = delete;

 private:
  std::optional<SignalHandler> handler_;
};

}  // namespace penumbra
