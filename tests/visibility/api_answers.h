// SPDX-License-Identifier: MIT
// Whether answers of the C API agree with one another.
#pragma once

#include <cstdint>
#include <optional>

#include "penumbra/penumbra_c.h"
#include "tests/visibility/api_arguments.h"

namespace penumbra::fuzz {

/// Of occluders that nobody else uses, whose last commit succeeded: how many points got the same
/// fraction, bit for bit, by `shaft` and `stochastic`, as samples and as a whole, and after they
/// were built anew. Nothing where something differs, which is printed.
std::optional<std::uint64_t> compare_answers(penumbra_occluders occluders, const Arrays& arrays,
                                             Random& random);

}  // namespace penumbra::fuzz
