// SPDX-License-Identifier: MIT
// What the paper reports of its measurements, held against ours; and what it comes to today.
#pragma once

#include "report.h"
#include "results.h"

namespace penumbra::reproduce {

struct Claims {
  Table table;
  std::vector<std::string> notes;  ///< what does not hold; and of the lights
};

Claims check_claims(const Results& results);

/// The paper's methods and ours beside packets of rays.
Table standing_today(const Results& results);

}  // namespace penumbra::reproduce
