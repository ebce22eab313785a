// SPDX-License-Identifier: MIT
// Where C++ ends: what calls throw becomes a code, a message, and a call of an error function.
#pragma once

#include <string>

#include "penumbra/penumbra_c.h"

namespace penumbra {

/// Thrown by the C API's own checks.
struct ApiError {
  penumbra_error code = PENUMBRA_ERROR_INTERNAL;
  std::string message;
};

/// PENUMBRA_ERROR_INVALID_ARGUMENT.
[[noreturn]] void refuse_argument(std::string message);

/// Throws where this thread is within a progress function.
void refuse_in_progress();

/// While it lives, this thread is within a progress function.
class InProgress {
 public:
  InProgress();
  ~InProgress();
  InProgress(const InProgress&) = delete;
  InProgress& operator=(const InProgress&) = delete;
};

/// The error that is being caught, as this thread's last, told to the error function of
/// `occluders`. Allocates nothing.
penumbra_error report_caught(const char* function, penumbra_occluders occluders) noexcept;

/// Runs `call` for the C function of that name.
template <class Call>
penumbra_error guarded(const char* function, penumbra_occluders occluders,
                       const Call& call) noexcept {
  try {
    refuse_in_progress();
    call();
    return PENUMBRA_OK;
  } catch (...) {
    return report_caught(function, occluders);
  }
}

}  // namespace penumbra
