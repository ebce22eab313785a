// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/pbrt_tokens.h"

#include <cmath>

#include "penumbra/scene_io/numbers.h"

namespace penumbra {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

bool ends_word(char c) { return is_space(c) || c == '"' || c == '[' || c == ']' || c == '#'; }

/// What a backslash and this letter stand for.
char escaped(char c) {
  switch (c) {
    case 'b': return '\b';
    case 'f': return '\f';
    case 'n': return '\n';
    case 'r': return '\r';
    case 't': return '\t';
    default: return c;
  }
}

}  // namespace

PbrtTokens::PbrtTokens(const std::string& file, std::string_view text) : file_(file), bytes_(text) {
  if (bytes_.starts_with("\xFE\xFF") || bytes_.starts_with("\xFF\xFE"))
    throw Error({file, 1, {}}, "the text is in UTF-16", "save it as UTF-8");
  if (bytes_.starts_with("\xEF\xBB\xBF")) at_ = 3;
}

const PbrtToken& PbrtTokens::peek() {
  if (!has_peeked_) peeked_ = read();
  has_peeked_ = true;
  return peeked_;
}

PbrtToken PbrtTokens::next() {
  if (!has_peeked_) return read();
  has_peeked_ = false;
  return peeked_;
}

PbrtToken PbrtTokens::read() {
  while (at_ < bytes_.size() && (is_space(bytes_[at_]) || bytes_[at_] == '#')) {
    if (bytes_[at_] == '#') {
      at_ = std::min(bytes_.find_first_of("\r\n", at_), bytes_.size());
      continue;
    }
    const bool before_newline = at_ + 1 < bytes_.size() && bytes_[at_ + 1] == '\n';
    if (bytes_[at_] == '\n' || (bytes_[at_] == '\r' && !before_newline)) ++line_;
    ++at_;
  }
  const PbrtPlace place{&file_, line_};
  if (at_ == bytes_.size()) return {PbrtTokenKind::end, {}, place};
  const std::size_t start = at_++;
  if (bytes_[start] == '[') return {PbrtTokenKind::open, bytes_.substr(start, 1), place};
  if (bytes_[start] == ']') return {PbrtTokenKind::close, bytes_.substr(start, 1), place};
  if (bytes_[start] == '"') return read_text(place);
  while (at_ < bytes_.size() && !ends_word(bytes_[at_])) ++at_;
  return {PbrtTokenKind::word, bytes_.substr(start, at_ - start), place};
}

PbrtToken PbrtTokens::read_text(PbrtPlace start) {
  const std::size_t first = at_;
  bool has_escapes = false;
  for (; at_ < bytes_.size() && bytes_[at_] != '"'; ++at_) {
    if (bytes_[at_] == '\n' || bytes_[at_] == '\r') break;
    if (bytes_[at_] != '\\') continue;
    has_escapes = true;
    if (++at_ == bytes_.size()) break;
  }
  if (at_ >= bytes_.size() || bytes_[at_] != '"')
    throw Error(start, "a quotation mark is not closed on its line", "close it with \"");
  const std::string_view raw = bytes_.substr(first, at_++ - first);
  if (!has_escapes) return {PbrtTokenKind::text, raw, start};
  unescaped_.clear();
  for (std::size_t i = 0; i < raw.size(); ++i) {
    const bool is_escape = raw[i] == '\\' && i + 1 < raw.size();
    unescaped_ += is_escape ? escaped(raw[++i]) : raw[i];
  }
  return {PbrtTokenKind::text, unescaped_, start};
}

void fail_pbrt_token(const PbrtToken& token, std::string_view what) {
  const std::string expected = "expected " + std::string(what);
  if (token.kind == PbrtTokenKind::end)
    throw Error(token.place, expected + ", but the file ends", "the file may be cut off");
  throw Error(token.place, expected + ", found " + in_quotes(token.text));
}

double pbrt_number(const PbrtToken& token, std::string_view what) {
  const auto value =
      token.kind == PbrtTokenKind::word ? parse_double(token.text) : std::optional<double>();
  if (!value || !std::isfinite(*value)) fail_pbrt_token(token, what);
  return *value;
}

double PbrtTokens::number(std::string_view what) { return pbrt_number(next(), what); }

std::string PbrtTokens::text(std::string_view what) {
  const PbrtToken token = next();
  if (token.kind != PbrtTokenKind::text) fail_pbrt_token(token, what);
  return std::string(token.text);
}

}  // namespace penumbra
