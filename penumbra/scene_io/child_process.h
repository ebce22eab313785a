// SPDX-License-Identifier: MIT
// Work that may crash, hang or want all memory there is, done by a process that may die of it.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace penumbra {

struct ChildLimits {
  std::size_t memory_bytes = std::size_t{3} << 30;  ///< beyond what this process has already
  std::size_t output_bytes = std::size_t{2} << 30;
  unsigned cpu_seconds = 120;
  unsigned wall_seconds = 180;
};

struct ChildResult {
  std::string output;   ///< what `work` returned
  std::string failure;  ///< empty, or why there is no output: "it crashed (signal 11)"
};

/// Runs `work` in a forked copy of this process, without stdin, stdout and stderr, and returns what
/// it returned. Exceptions of `work` are failures. Linux alone; there is no exec, so call it before
/// threads are started: of several threads only this one lives on in the copy, and what others had
/// locked stays so (then the time limit ends it).
ChildResult run_in_child(const std::function<std::string()>& work, const ChildLimits& limits = {});

}  // namespace penumbra
