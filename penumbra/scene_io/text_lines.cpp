// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/text_lines.h"

namespace penumbra {

namespace {

bool is_line_end(char c) { return c == '\n' || c == '\r'; }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || is_line_end(c); }

/// Where the line end at `at` stops: CR LF is one.
std::size_t after_line_end(std::string_view text, std::size_t at) {
  return at + (text.substr(at, 2) == "\r\n" ? 2 : 1);
}

/// A backslash with nothing but the end of a line behind it.
bool is_joint(std::string_view text, std::size_t at) {
  return text[at] == '\\' && (at + 1 == text.size() || is_line_end(text[at + 1]));
}

}  // namespace

std::optional<std::string_view> TextLines::next() {
  if (at_ >= text_.size()) return std::nullopt;
  number_ = following_++;
  const std::size_t begin = at_;
  while (true) {
    at_ = text_.find_first_of("\r\n", at_);
    if (at_ == std::string_view::npos) {
      at_ = text_.size();
      return text_.substr(begin);
    }
    const std::size_t end = at_;
    at_ = after_line_end(text_, at_);
    const bool is_joined =
        joints_ == LineJoints::backslash && end > begin && text_[end - 1] == '\\';
    if (!is_joined) return text_.substr(begin, end - begin);
    ++following_;
  }
}

std::string_view next_word(std::string_view& rest) {
  std::size_t begin = 0;
  while (begin < rest.size() && (is_space(rest[begin]) || is_joint(rest, begin))) ++begin;
  std::size_t end = begin;
  if (begin < rest.size() && rest[begin] == '#') {
    rest = {};
    return {};
  }
  while (end < rest.size() && !is_space(rest[end]) && !is_joint(rest, end)) ++end;
  const std::string_view word = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return word;
}

std::string_view trimmed(std::string_view rest) {
  while (!rest.empty() && is_space(rest.front())) rest.remove_prefix(1);
  while (!rest.empty() && is_space(rest.back())) rest.remove_suffix(1);
  return rest;
}

}  // namespace penumbra
