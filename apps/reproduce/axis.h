// SPDX-License-Identifier: MIT
// How far an axis goes and where its numbers stand.
#pragma once

#include <string>
#include <vector>

namespace penumbra::reproduce {

struct Axis {
  double low = 0, high = 1;
  bool has_log = false;
};

/// Encloses these values. A linear axis begins at 0 unless the values fill less than half of it; an
/// axis with logarithms takes positive values only. No values give 0 to 1, or 1 to 10.
Axis axis_around(const std::vector<double>& values, bool has_log);

/// gnuplot's list of tics for an axis with logarithms, `("1" 1, "2" 2, ...)`: plain numbers that
/// steps of 1, 2, 5 or 10 lead to, powers of ten where those would be long.
std::string log_tics(const Axis& axis);

}  // namespace penumbra::reproduce
