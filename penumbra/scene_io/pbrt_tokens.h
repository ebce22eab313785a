// SPDX-License-Identifier: MIT
// The words of pbrt-v4's scene files (pbrt.org/fileformat-v4), each with its place.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "penumbra/scene/error.h"

namespace penumbra {

/// Where something stands: a file that outlives its mentions, and a line of it.
struct PbrtPlace {
  const std::string* file = nullptr;
  std::size_t line = 0;

  operator Error::Place() const { return {file ? *file : std::string(), line, {}}; }
};

enum class PbrtTokenKind { word, text, open, close, end };

struct PbrtToken {
  PbrtTokenKind kind = PbrtTokenKind::end;
  std::string_view text;  ///< of a text what is between its quotes, escapes resolved
  PbrtPlace place;
};

/// Goes through a text once. `file` and `text` must outlive it; a token's text is good until the
/// next one is asked for.
class PbrtTokens {
 public:
  PbrtTokens(const std::string& file, std::string_view text);

  PbrtToken next();
  /// What `next` will give.
  const PbrtToken& peek();

  // The next token; otherwise throws Error that says what was expected.
  double number(std::string_view what);  ///< finite
  std::string text(std::string_view what);

 private:
  PbrtToken read();
  PbrtToken read_text(PbrtPlace start);

  const std::string& file_;
  std::string_view bytes_;
  std::size_t at_ = 0, line_ = 1;
  bool has_peeked_ = false;
  PbrtToken peeked_;
  std::string unescaped_;
};

/// Throws Error: "expected <what>, found <token>", or that the file ends there.
[[noreturn]] void fail_pbrt_token(const PbrtToken& token, std::string_view what);

/// The token as a finite number; throws Error otherwise.
double pbrt_number(const PbrtToken& token, std::string_view what);

}  // namespace penumbra
