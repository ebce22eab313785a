// SPDX-License-Identifier: MIT
// What the paper says of its measurements, held against ours.
#pragma once

#include "report.h"
#include "results.h"

namespace penumbra::reproduce {

struct Claims {
  Table table;
  std::vector<std::string> notes;  ///< what does not hold, and why; and of the lights
};

Claims check_claims(const Results& results);

}  // namespace penumbra::reproduce
