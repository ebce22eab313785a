// SPDX-License-Identifier: MIT
// A reproduction as one page that needs nothing but itself.
#pragma once

#include <map>
#include <string>

#include "report.h"

namespace penumbra::reproduce {

/// index.html, UTF-8: no scripts, no requests; pictures and plots are inside. It links to files
/// beside it: the galleries' full-size pictures, `<id>.csv` of tables and plots, `<id>.png` and
/// `<id>.svg` of plots. A plot without an SVG in the map has its links alone.
std::string to_html(const Report& report, const std::map<std::string, std::string>& svg_by_plot_id);

}  // namespace penumbra::reproduce
