// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "penumbra/scene_io/numbers.h"
#include "penumbra/scene_io/point_rows.h"
#include "penumbra/scene_io/text_lines.h"

namespace penumbra {
namespace {

constexpr std::size_t longest_line = std::size_t{1} << 16, most_columns = 1000;

std::string_view without_quotes(std::string_view field) {
  field = trimmed(field);
  if (field.size() >= 2 && field.front() == '"' && field.back() == '"')
    field = field.substr(1, field.size() - 2);
  return trimmed(field);
}

/// Where a field that begins at `begin` ends: at the separator, but for those between quotes.
std::size_t field_end(std::string_view line, std::size_t begin, char separator) {
  bool is_quoted = false;
  for (std::size_t i = begin; i < line.size(); ++i) {
    if (line[i] == '"') is_quoted = !is_quoted;
    if (line[i] == separator && !is_quoted) return i;
  }
  return is_quoted ? line.npos : line.size();
}

/// Of the first line of text behind `searched`, no farther than a line may be long.
std::size_t line_end(std::string_view text, std::size_t searched) {
  text = text.substr(0, longest_line + 1);
  if (searched >= text.size()) return text.npos;
  const std::size_t end = text.find('\n', searched);
  const std::size_t return_at = text.substr(0, end).find('\r', searched);
  return std::min(end, return_at);
}

const char* const number_names[] = {"x", "y", "z", "nx", "ny", "nz"};

}  // namespace

CsvRows::CsvRows(ByteInput& input) : input_(&input) {
  if (input.peek(3).starts_with("\xEF\xBB\xBF")) input.skip(3);
  read_first_line();
}

/// The next line's text; LF, CR LF and CR all end one.
bool CsvRows::next_line() {
  std::string_view text = input_->peek();
  if (was_carriage_return_ && text.starts_with('\n')) {
    input_->skip(1);
    text = input_->peek();
  }
  was_carriage_return_ = false;
  if (text.empty()) return false;
  ++line_number_;
  for (std::size_t searched = 0;;) {
    const std::size_t end = line_end(text, searched);
    if (end == text.npos && text.size() > longest_line)
      throw Error(place(), "the line is longer than 64 KiB",
                  "if these are no lines of text, say so with --input-format");
    if (end != text.npos) {
      was_carriage_return_ = text[end] == '\r';
      line_ = text.substr(0, end);
      input_->skip(end + 1);
      return true;
    }
    searched = text.size();
    text = input_->peek(searched + 1);
    if (text.size() > searched) continue;
    line_ = text;
    input_->skip(text.size());
    return true;
  }
}

/// By what the first line holds. Tabs between names are kept apart, since fields may be empty;
/// between numbers they are blanks like others.
void CsvRows::choose_separator(bool may_be_tab) {
  if (line_.find(';') != line_.npos)
    separator_ = Separator::semicolon;
  else if (line_.find(',') != line_.npos)
    separator_ = Separator::comma;
  else if (may_be_tab && line_.find('\t') != line_.npos)
    separator_ = Separator::tab;
  else
    separator_ = Separator::blanks;
}

void CsvRows::split() {
  fields_.clear();
  if (separator_ == Separator::blanks) {
    for (std::string_view rest = line_;;) {
      const std::string_view word = next_word(rest);
      if (word.empty()) return;
      if (fields_.size() == most_columns) break;
      fields_.push_back(without_quotes(word));
    }
  } else {
    const char separator = separator_ == Separator::comma       ? ','
                           : separator_ == Separator::semicolon ? ';'
                                                                : '\t';
    for (std::size_t begin = 0; fields_.size() < most_columns;) {
      const std::size_t end = field_end(line_, begin, separator);
      if (end == line_.npos) throw Error(place(), "a quote is not closed on its line", "close it");
      fields_.push_back(without_quotes(line_.substr(begin, end - begin)));
      begin = end + 1;
      if (end < line_.size()) continue;
      // A separator at the end of the line separates nothing.
      if (fields_.size() > 1 && fields_.back().empty() && fields_.size() > column_number_.size())
        fields_.pop_back();
      return;
    }
  }
  throw Error(place(), "has more than 1000 columns",
              "if these are no lines of text, say so with --input-format");
}

/// Whether the fields are names of columns, and points among them; keeps what they mean.
bool CsvRows::take_names() {
  std::array<bool, point_numbers> has{};
  std::vector<std::size_t> numbers;
  for (const std::string_view field : fields_) {
    const std::size_t number = point_number_named(field);
    if (number < point_numbers && std::exchange(has[number], true))
      throw Error(place(), "has two columns " + in_quotes(field), "give each column its own name");
    numbers.push_back(number);
  }
  if (std::none_of(has.begin(), has.end(), [](bool b) { return b; })) return false;
  check_point_columns(has, place());
  column_number_ = std::move(numbers);
  columns_line_ = line_number_;
  has_normals_ = has[3];
  return true;
}

/// NumPy's savetxt puts names into a comment. But comments are free: this is a guess, which the
/// first point has to confirm, and none of them is an error.
void CsvRows::guess_names(std::string_view comment) {
  if (comment.size() >= most_columns || comment.find('"') != comment.npos) return;
  line_ = comment;
  choose_separator(true);
  split();
  std::array<int, point_numbers + 1> times{};
  for (const std::string_view field : fields_) ++times[point_number_named(field)];
  const auto are_all = [&](std::size_t first, int count) {
    return times[first] == count && times[first + 1] == count && times[first + 2] == count;
  };
  if (are_all(0, 1) && (are_all(3, 0) || are_all(3, 1))) take_names();
}

/// Splits the line as the guess has it, or forgets that.
bool CsvRows::confirm_guess() {
  if (column_number_.empty()) return false;
  const auto fits = [this] {
    split();
    if (fields_.size() != column_number_.size()) return false;
    for (std::size_t i = 0; i < fields_.size(); ++i)
      if (column_number_[i] < 3 && parse_float(fields_[i])) return true;
    return false;
  };
  if (fits()) return true;
  choose_separator(false);
  if (fits()) return true;
  column_number_.clear();
  has_normals_ = false;
  return false;
}

/// 3 or 6 columns without names.
void CsvRows::number_columns() {
  if (fields_.size() != 3 && fields_.size() != point_numbers)
    throw Error(place(), "has " + std::to_string(fields_.size()) + " columns without names",
                "give 3 (x y z) or 6 (x y z nx ny nz), or a first line with their names");
  for (std::size_t i = 0; i < fields_.size(); ++i) column_number_.push_back(i);
  has_normals_ = fields_.size() == point_numbers;
  columns_line_ = line_number_;
}

void CsvRows::read_first_line() {
  bool has_names = false;  // in a line of their own
  while (next_line()) {
    const std::string_view text = trimmed(line_);
    if (text.empty()) continue;
    if (text.front() == '#') {
      if (!has_names) guess_names(text.substr(1));
      continue;
    }
    if (has_names) {
      split();
    } else if (!confirm_guess()) {
      choose_separator(true);
      split();
      has_names = !fields_.empty() && !parse_float(fields_.front()) && take_names();
      if (has_names) continue;
      choose_separator(false);
      split();
      number_columns();
    }
    first_ = row();
    return;
  }
}

PointRow CsvRows::row() const {
  if (fields_.size() != column_number_.size())
    throw Error(place(),
                "has " + std::to_string(fields_.size()) + " columns, but line " +
                    std::to_string(columns_line_) + " has " + std::to_string(column_number_.size()),
                "give each point all of them");
  std::array<float, point_numbers> numbers{};
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const std::size_t number = column_number_[i];
    if (number == point_numbers) continue;
    const std::optional<float> value = parse_float(fields_[i]);
    if (!value)
      throw Error(place(),
                  std::string("expected a number for ") + number_names[number] + ", found " +
                      in_quotes(fields_[i]),
                  "give decimal numbers with a point; for other formats see --input-format");
    numbers[number] = *value;
  }
  return row_of(numbers);
}

std::optional<PointRow> CsvRows::next() {
  if (first_) return std::exchange(first_, std::nullopt);
  while (next_line()) {
    const std::string_view text = trimmed(line_);
    if (text.empty() || text.front() == '#') continue;
    split();
    return row();
  }
  return {};
}

}  // namespace penumbra
