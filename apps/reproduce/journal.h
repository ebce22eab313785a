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
  /// Reads the file if there is one; lines that were cut off or damaged are left out. Throws Error
  /// where a line is of another machine, version or `run` (a name for all else that must agree:
  /// effort, files), so that nobody's hour of measuring is lost, and where the file is something
  /// else.
  Journal(std::filesystem::path path, Machine machine, std::string run);

  std::span<const Measurement> all() const { return measurements_; }

  /// Nullptr when it was not measured.
  const Measurement* find(const Setting& setting, const std::string& method) const;

  /// Keeps them, as this program's, in place of what was there of their settings, and writes the
  /// file anew. Throws Error.
  void add(std::vector<Measurement> measured);

 private:
  std::filesystem::path path_;
  Machine machine_;
  std::string run_;
  std::vector<Measurement> measurements_;
};

}  // namespace penumbra::reproduce
