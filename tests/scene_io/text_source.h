// SPDX-License-Identifier: MIT
// Files in memory, and what a reader says of them.
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "penumbra/scene_io/source.h"

namespace penumbra {

inline Source source_of(const std::string& name, std::string bytes) {
  const std::string extension = name.substr(name.rfind('.') + 1);
  return {name, extension, std::move(bytes)};
}

/// The message of the Error that `work` throws; empty when it throws none.
inline std::string error_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

inline bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace penumbra
