// SPDX-License-Identifier: MIT
#include "tests/scene_io/fuzz/mutation.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace penumbra {
namespace {

constexpr std::array<std::string_view, 30> extreme_numbers{"-1",
                                                           "0",
                                                           "1",
                                                           "-0",
                                                           "2",
                                                           "3",
                                                           "64",
                                                           "255",
                                                           "256",
                                                           "65535",
                                                           "65536",
                                                           "1000000",
                                                           "2147483647",
                                                           "2147483648",
                                                           "-2147483648",
                                                           "4294967295",
                                                           "4294967296",
                                                           "9223372036854775807",
                                                           "18446744073709551616",
                                                           "1e39",
                                                           "-1e39",
                                                           "1e-50",
                                                           "1e308",
                                                           "1e999",
                                                           "1e15",
                                                           "1e16",
                                                           "nan",
                                                           "inf",
                                                           "0.5",
                                                           "1e"};

constexpr std::array<std::string_view, 22> nasty_bytes{"\n",
                                                       " ",
                                                       "\t",
                                                       "\r",
                                                       "\"",
                                                       "'",
                                                       "\\",
                                                       "/",
                                                       "[",
                                                       "]",
                                                       "{",
                                                       "}",
                                                       "#",
                                                       "-",
                                                       ",",
                                                       ":",
                                                       "!",
                                                       ";",
                                                       "\xff\xff",
                                                       "\xef\xbb\xbf",
                                                       "\x7f\xff\xff\xff",
                                                       std::string_view("\0\0\0\0", 4)};

struct Part {
  std::size_t begin = 0, size = 0;
};

bool is_word_byte(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.' ||
         c == '-' || c == '+' || c == '_';
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The word around or after a random place; empty where none follows.
Part some_word(std::string_view text, Dice& dice) {
  std::size_t begin = dice.below(text.size());
  while (begin < text.size() && !is_word_byte(text[begin])) ++begin;
  while (begin > 0 && begin < text.size() && is_word_byte(text[begin - 1])) --begin;
  std::size_t end = begin;
  while (end < text.size() && is_word_byte(text[end])) ++end;
  return {begin, end - begin};
}

/// A number's word, if one of a few tries finds it.
Part some_number(std::string_view text, Dice& dice) {
  for (int tries = 0; tries < 8; ++tries) {
    const Part word = some_word(text, dice);
    const std::string_view found = text.substr(word.begin, word.size);
    if (std::any_of(found.begin(), found.end(), is_digit)) return word;
  }
  return some_word(text, dice);
}

/// The line around a random place, with its end.
Part some_line(std::string_view text, Dice& dice) {
  const std::size_t at = dice.below(text.size());
  const std::size_t before = at == 0 ? text.npos : text.rfind('\n', at - 1);
  const std::size_t begin = before == text.npos ? 0 : before + 1;
  const std::size_t after = text.find('\n', at);
  const std::size_t end = after == text.npos ? text.size() : after + 1;
  return {begin, end > begin ? end - begin : 0};
}

Part some_range(std::string_view text, Dice& dice) {
  const std::size_t begin = dice.below(text.size());
  return {begin, 1 + dice.below(dice.one_in(4) ? text.size() - begin : 12)};
}

Part some_part(std::string_view text, Dice& dice) {
  switch (dice.below(3)) {
    case 0: return some_word(text, dice);
    case 1: return some_line(text, dice);
    default: return some_range(text, dice);
  }
}

void flip_or_set(std::string& bytes, Dice& dice) {
  const std::size_t at = dice.below(bytes.size());
  if (dice.one_in(2))
    bytes[at] = static_cast<char>(dice.below(256));
  else
    bytes[at] = static_cast<char>(bytes[at] ^ static_cast<char>(1 << dice.below(8)));
}

/// What counts and offsets are in binary files, in either byte order.
void set_binary_number(std::string& bytes, Dice& dice) {
  constexpr std::array<std::uint32_t, 10> numbers{
      0, 1, 0xff, 0xffff, 0x7fffffff, 0x80000000, 0xffffffff, 0x7f800000, 0x7fc00000, 0x10000};
  const std::uint32_t number = numbers[dice.below(numbers.size())];
  const bool is_big_endian = dice.one_in(4);
  const std::size_t at = dice.below(bytes.size() / 4 + 1) * (dice.one_in(2) ? 4 : 1);
  for (std::size_t i = 0; i < 4 && at + i < bytes.size(); ++i)
    bytes[at + i] = static_cast<char>(number >> 8 * (is_big_endian ? 3 - i : i));
}

void swap_words(std::string& bytes, Dice& dice) {
  Part first = some_word(bytes, dice), second = some_word(bytes, dice);
  if (first.begin > second.begin) std::swap(first, second);
  if (first.begin + first.size > second.begin) return;
  const std::string a = bytes.substr(first.begin, first.size),
                    b = bytes.substr(second.begin, second.size);
  bytes.replace(second.begin, second.size, a).replace(first.begin, first.size, b);
}

void insert_part(std::string& bytes, std::string_view from, Dice& dice) {
  const Part part = some_part(from, dice);
  const Part place = some_part(bytes, dice);
  bytes.insert(place.begin, from.substr(part.begin, part.size));
}

/// A part many times over: lists that grow, and what opens without closing.
void repeat_part(std::string& bytes, Dice& dice) {
  const Part part = some_part(bytes, dice);
  const std::string once = bytes.substr(part.begin, part.size);
  constexpr std::size_t enough = std::size_t{1} << 18;
  std::string all;
  for (std::size_t times = std::size_t{1} << dice.below(13); times > 0 && all.size() < enough;
       --times)
    all += once;
  bytes.insert(part.begin, all);
}

void change(std::string& bytes, const std::vector<std::string>& samples, Dice& dice) {
  const std::string& other = samples[dice.below(samples.size())];
  switch (dice.below(12)) {
    case 0: return flip_or_set(bytes, dice);
    case 1: return set_binary_number(bytes, dice);
    case 2: return swap_words(bytes, dice);
    case 3: return insert_part(bytes, std::string(bytes), dice);
    case 4: return insert_part(bytes, other, dice);
    case 5: {
      const Part part = some_part(bytes, dice);
      bytes.erase(part.begin, part.size);
      return;
    }
    case 6:
    case 7: {
      const Part number = some_number(bytes, dice);
      bytes.replace(number.begin, number.size, extreme_numbers[dice.below(extreme_numbers.size())]);
      return;
    }
    case 8: {
      const Part place = some_range(bytes, dice);
      bytes.insert(place.begin, nasty_bytes[dice.below(nasty_bytes.size())]);
      return;
    }
    case 9:
      if (dice.one_in(3)) bytes.resize(dice.below(bytes.size()));
      return;
    case 10:
      if (dice.one_in(3)) repeat_part(bytes, dice);
      return;
    case 11:
      bytes.resize(some_part(bytes, dice).begin);
      bytes += std::string_view(other).substr(some_part(other, dice).begin);
      return;
  }
}

}  // namespace

std::string damaged(const std::vector<std::string>& samples, Dice& dice, std::size_t most_bytes) {
  std::string bytes = samples[dice.below(samples.size())];
  const std::size_t changes = 1 + dice.below(dice.one_in(4) ? 12 : 4);
  for (std::size_t i = 0; i < changes && !bytes.empty(); ++i) {
    change(bytes, samples, dice);
    if (bytes.size() > most_bytes) bytes.resize(most_bytes);
  }
  return bytes;
}

}  // namespace penumbra
