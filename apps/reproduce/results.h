// SPDX-License-Identifier: MIT
// What was measured, by what it is asked for; and numbers as people read them.
#pragma once

#include <cstdint>
#include <string>

#include "journal.h"
#include "plan.h"

namespace penumbra::reproduce {

/// The plan's measurements: all of them must be in the journal.
struct Results {
  const Plan& plan;
  const Journal& journal;

  const Measurement& of(const Setting& setting, const std::string& method) const;
  const Measurement& of(const Setting& setting, Contender contender) const {
    return of(setting, name_of(contender));
  }
};

/// One of the paper's rows, (a) to (e), and of ours.
struct Variant {
  std::string label;   ///< "(b) stochastic"
  std::string method;  ///< as measured
  bool is_beyond = false;
};
/// (a) to (e) as tracers of the time did them, then those of today.
const std::vector<Variant>& variants();

/// The fastest of (c) to (e) in a setting.
const Measurement& best_proof(const Results& results, const Setting& setting);

/// For file names: "cylinders".
const char* slug_of(PaperSceneIndex scene);

/// "Cylinders", or the name of the file that stands in.
std::string title_of(const Plan& plan, PaperSceneIndex scene);

/// "1,397,529"
std::string grouped(std::uint64_t number);
/// Three significant digits: "0.413", "12.1", "1,230".
std::string rounded(double number);
/// "12.3 ms ± 2 %": half the distance of the quartiles.
std::string with_spread(const Timing& timing);

}  // namespace penumbra::reproduce
