// SPDX-License-Identifier: MIT
// Tables and plots as text: CSV for programs, Markdown for documents.
#pragma once

#include <string>

#include "report.h"

namespace penumbra::reproduce {

/// One line a row, quoted after RFC 4180, lines end in a line feed: the label, then for each column
/// our figure and, where a row of it has one, the paper's under "column, paper".
std::string to_csv(const Table& table);

/// "curve,x,y,low,high", one line a point.
std::string to_csv(const Plot& plot);

/// The tables with their titles and texts, the paper's figures in brackets and italics.
std::string to_markdown(const Report& report);

}  // namespace penumbra::reproduce
