// SPDX-License-Identifier: MIT
// Beyond the paper: speed against the size of lights and pictures, and growth with the scene.
#pragma once

#include <vector>

#include "report.h"
#include "results.h"

namespace penumbra::reproduce {

/// Speed-up of `shaft` over Embree and over our own packets, and its ratio to one ray a point,
/// against the light's radius.
std::vector<Plot> speed_against_light(const Results& results);

/// The same against the picture's size.
std::vector<Plot> speed_against_size(const Results& results);

/// Shadow time a question against the number of objects.
Plot growth(const Results& results);

}  // namespace penumbra::reproduce
