// SPDX-License-Identifier: MIT
// The page's longer texts. Paragraphs end at empty lines; other line ends are blanks.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace penumbra::reproduce {

std::vector<std::string> paragraphs(std::string_view text);

extern const char* const paper_reference;
extern const char* const what_methods_are;  ///< one method a paragraph
extern const char* const about_tables;
extern const char* const where_we_differ;

}  // namespace penumbra::reproduce
