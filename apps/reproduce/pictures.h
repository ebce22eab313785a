// SPDX-License-Identifier: MIT
// The paper's Figures 9 to 13: its scenes, and what is proven of them.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "plan.h"
#include "report.h"
#include "scenes.h"

namespace penumbra::reproduce {

/// Renders each scene under its own lights, antialiased, and its class maps: of the samples, of
/// `umbra` and of `shaft`. Writes them as PNG files into the folder. `progress` is told the
/// finished share. Throws Error.
std::vector<Gallery> draw_pictures(const Plan& plan, Scenes& scenes,
                                   const std::filesystem::path& folder,
                                   const std::function<void(double)>& progress);

}  // namespace penumbra::reproduce
