// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/tokens.h"

#include <cmath>
#include <utility>

#include "penumbra/scene_io/numbers.h"

namespace penumbra {
namespace {

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v';
}

}  // namespace

Tokens::Tokens(std::string file, std::string_view text, Comments comments, std::size_t first_line)
    : file_(std::move(file)), text_(text), comments_(comments), line_(first_line) {
  if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
}

void Tokens::skip_line() { at_ = std::min(text_.find_first_of("\r\n", at_), text_.size()); }

std::string_view Tokens::rest_of_line() {
  const std::size_t start = at_;
  skip_line();
  std::string_view rest = text_.substr(start, at_ - start);
  while (!rest.empty() && is_space(rest.front())) rest.remove_prefix(1);
  while (!rest.empty() && is_space(rest.back())) rest.remove_suffix(1);
  return rest;
}

void Tokens::skip_comment() {
  const std::size_t start = at_;
  skip_line();
  const std::string_view comment = text_.substr(start, at_ - start);
  if (comment.starts_with("#! ")) directives_.push_back({comment.substr(3), line_});
}

void Tokens::skip_space() {
  for (; at_ < text_.size(); ++at_) {
    while (comments_ == Comments::hash && at_ < text_.size() && text_[at_] == '#') skip_comment();
    if (at_ == text_.size() || !is_space(text_[at_])) return;
    const bool before_newline = at_ + 1 < text_.size() && text_[at_ + 1] == '\n';
    if (text_[at_] == '\n' || (text_[at_] == '\r' && !before_newline)) ++line_;
  }
}

Token Tokens::peek() {
  skip_space();
  std::size_t end = at_;
  while (end < text_.size() && !is_space(text_[end]) &&
         !(comments_ == Comments::hash && text_[end] == '#'))
    ++end;
  return {text_.substr(at_, end - at_), line_};
}

Token Tokens::next() {
  const Token token = peek();
  at_ += token.text.size();
  return token;
}

std::vector<Token> Tokens::take_directives() { return std::exchange(directives_, {}); }

float Tokens::number(std::string_view what) {
  const Token token = next();
  const std::optional<float> value = parse_float(token.text);
  if (!value || !std::isfinite(*value)) fail(token, what);
  return *value;
}

double Tokens::number_double(std::string_view what) {
  const Token token = next();
  const std::optional<double> value = parse_double(token.text);
  if (!value || !std::isfinite(*value)) fail(token, what);
  return *value;
}

std::int64_t Tokens::integer(std::string_view what) {
  const Token token = next();
  const std::optional<std::int64_t> value = parse_integer(token.text);
  if (!value) fail(token, what);
  return *value;
}

void Tokens::fail(const Token& token, std::string_view what) const {
  if (token.text.empty())
    throw Error(place(token), "expected " + std::string(what) + ", found the end",
                "it may be cut off");
  const std::optional<float> value = parse_float(token.text);
  if (value && !std::isfinite(*value))
    throw Error(place(token),
                in_quotes(token.text) + " is no finite number for " + std::string(what));
  throw Error(place(token), "expected " + std::string(what) + ", found " + in_quotes(token.text));
}

}  // namespace penumbra
