// SPDX-License-Identifier: MIT
// The figures of the page: tables, galleries, plots.
#pragma once

#include <string>

#include "report.h"

namespace penumbra::reproduce {

std::string table_html(const Table& table);

/// Works without scripts: radio inputs, and rules of the style sheet that show the chosen one.
std::string gallery_html(const Gallery& gallery);

std::string plot_html(const Plot& plot, const std::string& svg);

}  // namespace penumbra::reproduce
