// SPDX-License-Identifier: MIT
// What was measured, by what it is asked for, and under which names.
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

/// A row of the tables.
struct Variant {
  std::string label;   ///< "(b) stochastic"
  std::string method;  ///< as measured
};
/// (a) to (e) as tracers of the time did them.
const std::vector<Variant>& paper_variants();
/// Two in packets, shaft, then Embree, and hard by Embree.
const std::vector<Variant>& todays_variants();

/// The fastest of (c) to (e) in a setting.
const Measurement& best_proof(const Results& results, const Setting& setting);

/// For file names: "cylinders".
const char* slug_of(PaperSceneIndex scene);

/// "Cylinders", or the name of the file that stands in.
std::string title_of(const Plan& plan, PaperSceneIndex scene);

/// Of all scenes, in the paper's order.
std::vector<std::string> scene_titles(const Plan& plan);

/// "12.3 ms ± 2 %": half the distance of the quartiles; without it where there was one round.
std::string with_spread(const Timing& timing, std::uint32_t rounds);

}  // namespace penumbra::reproduce
