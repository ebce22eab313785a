// SPDX-License-Identifier: MIT
// All measurements of a run, kept in a CSV file as they come, so that an interrupted run goes on
// where it was, and so that others can compute with every number.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "../machine.h"
#include "measurement.h"

namespace penumbra::reproduce {

class Journal {
 public:
  /// Reads the file if there is one. Its rows count when they were made with the same machine,
  /// version and `run` (a name for all else that must agree: rounds, files); others are dropped,
  /// and `dropped` says how many. Throws Error where the file cannot be read.
  Journal(std::filesystem::path path, Machine machine, std::string run);

  std::size_t dropped() const { return dropped_; }
  std::span<const Measurement> all() const { return measurements_; }

  /// Nullptr when it was not measured.
  const Measurement* find(const Setting& setting, const std::string& method) const;

  /// Keeps them, and writes the file anew. Throws Error.
  void add(std::vector<Measurement> measured);

 private:
  std::filesystem::path path_;
  Machine machine_;
  std::string run_;
  std::size_t dropped_ = 0;
  std::vector<Measurement> measurements_;
};

}  // namespace penumbra::reproduce
