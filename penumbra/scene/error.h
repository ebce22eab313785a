// SPDX-License-Identifier: MIT
// The one exception: bad input. Programs catch it once, print `message()`, and exit with 1.
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

namespace penumbra {

/// What is wrong with an input, where, and what to do about it.
struct Error : std::runtime_error {
  /// Anything unknown is empty: `file`, `position`.
  struct Place {
    std::string file;
    std::optional<std::size_t> line;  ///< from 1
    std::optional<std::size_t> byte;  ///< offset from 0, for binary files
  };

  /// `what` is wrong; the hint says what to do about it.
  Error(Place where, std::string what, std::string hint = {});

  Place place;
  std::string problem;
  std::string hint;
};

/// "file:line: what, and what to do" (or "file: byte N: ...").
std::string message(const Error::Place& place, const std::string& problem, const std::string& hint);

}  // namespace penumbra
