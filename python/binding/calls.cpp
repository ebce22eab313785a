// SPDX-License-Identifier: MIT
#include "calls.h"

#include <utility>

namespace penumbra::python {
namespace {

/// How often Python is asked: the lock costs more than points do.
constexpr std::chrono::milliseconds pause{50};

}  // namespace

Watch::Watch(py::object progress) : progress_(std::move(progress)) {
  if (!progress_.is_none() && !PyCallable_Check(progress_.ptr()))
    throw py::type_error("progress must be callable: it gets the finished share, 0 to 1");
}

bool Watch::goes_on(double share) {
  if (raised_) return false;
  const Clock::time_point now = Clock::now();
  // Signals come through in the main thread alone, so each caller looks after its own.
  const bool looks = std::this_thread::get_id() == caller_ && now - looked_ >= pause;
  const bool tells = !progress_.is_none() && (now - told_ >= pause || share >= 1);
  if (!looks && !tells) return true;
  if (looks) looked_ = now;
  if (tells) told_ = now;
  const py::gil_scoped_acquire locked;
  try {
    if (looks && PyErr_CheckSignals() != 0) throw py::error_already_set();
    return !tells || tell(share);
  } catch (py::error_already_set& raised) {
    raised_.emplace(std::move(raised));
    return false;
  }
}

bool Watch::tell(double share) {
  const py::object answer = progress_(share);
  const int goes_on = answer.is_none() ? 1 : PyObject_IsTrue(answer.ptr());
  if (goes_on == 1) return true;
  if (goes_on < 0) throw py::error_already_set();
  PyErr_SetString(py::module_::import("penumbra._penumbra").attr("Cancelled").ptr(),
                  "progress returned what is false");
  throw py::error_already_set();
}

}  // namespace penumbra::python
