// SPDX-License-Identifier: MIT
// Rows of random trials that can be repeated from where one failed.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>

#include "tests/kernel/nasty_shapes.h"

namespace penumbra {

/// Calls round(random) for one seed after the other until `done`, which it counts up, reaches
/// `wanted` or something fails fatally; what fails is said with its seed.
template <class F>
void for_each_seed(std::uint64_t first, const std::uint64_t& done, std::uint64_t wanted,
                   F&& round) {
  for (std::uint64_t seed = first; done < wanted && !testing::Test::HasFatalFailure(); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    nasty::Random random(seed);
    round(random);
  }
}

}  // namespace penumbra
