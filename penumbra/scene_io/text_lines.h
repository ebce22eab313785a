// SPDX-License-Identifier: MIT
// Text formats by lines, where a line is a statement (OBJ, MTL); what tokens.h is where it is not.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace penumbra {

/// Whether a backslash at the end of a line joins it with the next.
enum class LineJoints { none, backslash };

/// Walks through the lines of a text. LF, CR LF and CR all end one; a byte order mark is skipped.
class TextLines {
 public:
  TextLines(std::string_view text, LineJoints joints)
      : text_(text), joints_(joints), at_(text.starts_with("\xEF\xBB\xBF") ? 3 : 0) {}

  /// The next line with its continuations but without its end; nothing after the last one.
  std::optional<std::string_view> next();
  /// Number of the line that `next` returned last (its first one, where lines were joined), from 1.
  std::size_t number() const { return number_; }

 private:
  std::string_view text_;
  LineJoints joints_;
  std::size_t at_ = 0;
  std::size_t number_ = 0, following_ = 1;
};

/// Takes the next word off the front of `rest`; empty at the end of the line and where a comment
/// (`#`) begins. Backslashes that join lines count as space.
std::string_view next_word(std::string_view& rest);

/// `rest` without space around it.
std::string_view trimmed(std::string_view rest);

}  // namespace penumbra
