// SPDX-License-Identifier: MIT
// A wrong option, as opposed to a wrong input: printed with the way to the help, exit code 2.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

struct UsageError : std::runtime_error {
  explicit UsageError(const std::string& what, std::vector<std::string> expected = {})
      : std::runtime_error(what), choices(std::move(expected)) {}

  std::vector<std::string> choices;  ///< where only a few words are taken: which
};
