// SPDX-License-Identifier: MIT
// Radiance scene files as words: cut at white space, in single or double quotes with spaces, and
// without comments, which begin with '#' at the start of a word.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "penumbra/scene_io/tokens.h"

namespace penumbra {

/// Goes through a text once. The text must outlive the words.
class RadianceWords {
 public:
  RadianceWords(std::string file, std::string_view text);

  /// The next word, without its quotes; empty at the end of the text.
  Token next();
  /// True where a `!` comes next, which begins a command.
  bool at_command();
  /// A command: what follows its `!` to the end of the line, lines that end in a backslash joined
  /// with the next by a space.
  std::string command();

  // The next word as a number; otherwise throws Error that says for what.
  double number(std::string_view what);  ///< finite
  /// How many words follow, each at least a character and a space long.
  std::size_t count(std::string_view what);

  std::size_t line() const { return line_; }
  Error::Place place(const Token& token) const { return {file_, token.line, std::nullopt}; }
  /// Throws Error: "expected <what>, found <token>", or that the file ends there.
  [[noreturn]] void fail(const Token& token, std::string_view what) const;

 private:
  void skip_space();

  std::string file_;
  std::string_view text_;
  std::size_t at_ = 0, line_ = 1;
};

}  // namespace penumbra
