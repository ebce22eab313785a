// SPDX-License-Identifier: MIT
// Numbers as people read them.
#pragma once

#include <cstdint>
#include <string>

namespace penumbra::reproduce {

/// "1,397,529"
std::string grouped(std::int64_t number);

/// Three significant digits: "0.413", "12.1", "1,230"; "-" for what is not finite.
std::string rounded(double number);

}  // namespace penumbra::reproduce
