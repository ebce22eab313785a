// SPDX-License-Identifier: MIT
// A wrong option, as opposed to a wrong input: printed with the way to the help, exit code 2.
#pragma once

#include <stdexcept>

struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};
