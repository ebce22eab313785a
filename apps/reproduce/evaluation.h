// SPDX-License-Identifier: MIT
// From measurements and pictures to the page's contents and words.
#pragma once

#include "../machine.h"
#include "report.h"
#include "results.h"

namespace penumbra::reproduce {

Report evaluate(const Results& results, const Machine& machine, std::vector<Gallery> pictures);

}  // namespace penumbra::reproduce
