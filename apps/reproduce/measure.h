// SPDX-License-Identifier: MIT
// Does what is planned, and keeps it.
#pragma once

#include <functional>

#include "journal.h"
#include "plan.h"
#include "scenes.h"

namespace penumbra::reproduce {

/// Measures all that the journal lacks: camera rays through pixels' corners, one thread, methods
/// interleaved. `progress` is told the finished share of the work, estimated. Answers that differ
/// from those of `stochastic` end it with an Error.
void measure_all(const Plan& plan, Scenes& scenes, Journal& journal,
                 const std::function<void(double)>& progress);

}  // namespace penumbra::reproduce
