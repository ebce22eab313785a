// SPDX-License-Identifier: MIT
// Pearson's test of counts against expected shares.
#pragma once

#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace penumbra {

/// Standard normal deviate of the statistic (E. B. Wilson, M. M. Hilferty 1931): 3.9 is exceeded
/// with a probability of 5e-5, as is -3.9 from below. Bins that expect less than 5 are merged.
inline double chi_squared_deviate(const std::vector<double>& counts,
                                  const std::vector<double>& shares) {
  const double total = std::accumulate(counts.begin(), counts.end(), 0.0);
  const double all_shares = std::accumulate(shares.begin(), shares.end(), 0.0);
  double statistic = 0, bins = 0, count = 0, expected = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    count += counts[i];
    expected += shares[i] / all_shares * total;
    if (expected < 5 && i + 1 < counts.size()) continue;
    if (expected > 0) statistic += (count - expected) * (count - expected) / expected;
    if (expected == 0 && count > 0) return INFINITY;
    bins += 1, count = 0, expected = 0;
  }
  const double freedom = bins - 1, spread = 2 / (9 * freedom);
  return (std::cbrt(statistic / freedom) - (1 - spread)) / std::sqrt(spread);
}

}  // namespace penumbra
