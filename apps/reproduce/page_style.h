// SPDX-License-Identifier: MIT
// The style sheet of the page.
#pragma once

#include <string>

namespace penumbra::reproduce {

std::string page_style();

}  // namespace penumbra::reproduce
