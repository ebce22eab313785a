// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/radiance_words.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "penumbra/scene_io/numbers.h"

namespace penumbra {
namespace {

bool is_line_end(char c) { return c == '\n' || c == '\r'; }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\f' || c == '\v' || is_line_end(c); }

}  // namespace

RadianceWords::RadianceWords(std::string file, std::string_view text)
    : file_(std::move(file)), text_(text), at_(text.starts_with("\xEF\xBB\xBF") ? 3 : 0) {}

void RadianceWords::skip_space() {
  for (; at_ < text_.size(); ++at_) {
    if (text_[at_] == '#') at_ = std::min(text_.find_first_of("\r\n", at_), text_.size());
    if (at_ == text_.size() || !is_space(text_[at_])) return;
    const bool before_newline = at_ + 1 < text_.size() && text_[at_ + 1] == '\n';
    if (text_[at_] == '\n' || (text_[at_] == '\r' && !before_newline)) ++line_;
  }
}

Token RadianceWords::next() {
  skip_space();
  if (at_ == text_.size()) return {{}, line_};
  const char first = text_[at_];
  if (first == '"' || first == '\'') {
    const char ends[] = {first, '\n', '\r', '\0'};
    const std::size_t begin = at_ + 1, end = text_.find_first_of(ends, begin);
    if (end != std::string_view::npos && text_[end] == first && end > begin) {
      at_ = end + 1;
      return {text_.substr(begin, end - begin), line_};
    }
  }
  const std::size_t begin = at_;
  while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
  return {text_.substr(begin, at_ - begin), line_};
}

bool RadianceWords::at_command() {
  skip_space();
  return at_ < text_.size() && text_[at_] == '!';
}

std::string RadianceWords::command() {
  std::string words;
  for (++at_;;) {
    const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
    words += text_.substr(at_, end - at_);
    at_ = end;
    if (words.empty() || words.back() != '\\' || at_ == text_.size()) return words;
    words.back() = ' ';
    at_ += text_.substr(at_, 2) == "\r\n" ? 2 : 1;
    ++line_;
  }
}

double RadianceWords::number(std::string_view what) {
  Token token = next();
  // A comment may follow a number without a space between them.
  if (const std::size_t comment = token.text.find('#'); comment != std::string_view::npos) {
    at_ -= token.text.size() - comment;
    token.text = token.text.substr(0, comment);
  }
  const std::optional<double> value = parse_double(token.text);
  if (!value || !std::isfinite(*value)) fail(token, what);
  return *value;
}

std::size_t RadianceWords::count(std::string_view what) {
  const Token token = next();
  const std::optional<std::int64_t> value = parse_integer(token.text);
  if (!value || *value < 0) fail(token, what);
  const std::size_t most = (text_.size() - at_ + 1) / 2;
  if (static_cast<std::uint64_t>(*value) > most)
    throw Error(place(token),
                fmt::format("{} is {}, but only {} bytes follow", what, *value, text_.size() - at_),
                "the file may be cut off, or the count wrong");
  return static_cast<std::size_t>(*value);
}

void RadianceWords::fail(const Token& token, std::string_view what) const {
  if (token.text.empty())
    throw Error(place(token), fmt::format("expected {}, found the end", what),
                "the file may be cut off, or a count too large");
  throw Error(place(token), fmt::format("expected {}, found {}", what, in_quotes(token.text)),
              "check the counts of arguments before it");
}

}  // namespace penumbra
