// SPDX-License-Identifier: MIT
// Long calls without the interpreter's lock, which Ctrl-C and the caller's `progress` can end.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <optional>
#include <thread>
#include <type_traits>
#include <utility>

namespace penumbra::python {

namespace py = pybind11;

/// Watches over one long call. Made, and destroyed, with the lock of the interpreter held.
class Watch {
 public:
  /// `progress`: None, or a callable that gets the finished share; what is false, but not
  /// None, ends the call.
  explicit Watch(py::object progress);

  /// The library's `progress`: from any thread, one call at a time. False ends the call.
  bool goes_on(double share);

  /// Does `work` without the lock; where `goes_on` said no, raises what ended the call.
  template <class Work>
  auto run(Work work) {
    std::optional<std::invoke_result_t<Work>> result;
    try {
      const py::gil_scoped_release unlocked;
      result.emplace(work());
    } catch (...) {
      if (!raised_) throw;
    }
    if (raised_) throw std::move(*raised_);
    return *std::move(result);
  }

 private:
  using Clock = std::chrono::steady_clock;

  bool tell(double share);

  py::object progress_;
  const std::thread::id caller_ = std::this_thread::get_id();
  Clock::time_point told_, looked_;
  std::optional<py::error_already_set> raised_;
};

}  // namespace penumbra::python
