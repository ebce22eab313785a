// SPDX-License-Identifier: MIT
// Text cut at white space, each token with its line; what the text readers read by.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "penumbra/scene/error.h"

namespace penumbra {

struct Token {
  std::string_view text;  ///< empty at the end of the file
  std::size_t line = 1;
};

enum class Comments { none, hash };  ///< hash: from '#' to the end of the line

/// Goes through a text once. Lines end with \n, \r\n or \r; a byte order mark is skipped. The text
/// must outlive the tokens.
class Tokens {
 public:
  Tokens(std::string file, std::string_view text, Comments comments, std::size_t first_line = 1);

  Token next();
  /// What `next` will give.
  Token peek();
  /// Skips what is left of the current line.
  void skip_line();
  /// What is left of the current line, without the space around it.
  std::string_view rest_of_line();
  /// Bytes that are left: a claimed number of tokens needs about two each.
  std::size_t remaining() const { return text_.size() - at_; }
  /// Comments that began with "#! ", without those four characters, met since the last call.
  std::vector<Token> take_directives();

  // The next token as a number; otherwise throws Error that says for what.
  float number(std::string_view what);          ///< finite
  double number_double(std::string_view what);  ///< finite
  std::int64_t integer(std::string_view what);

  const std::string& file() const { return file_; }
  Error::Place place(const Token& token) const { return {file_, token.line, std::nullopt}; }
  /// Throws Error: "expected <what>, found <token>", or that the file ends there.
  [[noreturn]] void fail(const Token& token, std::string_view what) const;

 private:
  void skip_space();
  void skip_comment();

  std::string file_;
  std::string_view text_;
  Comments comments_;
  std::size_t at_ = 0, line_ = 1;
  std::vector<Token> directives_;
};

}  // namespace penumbra
