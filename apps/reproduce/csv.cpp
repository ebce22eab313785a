// SPDX-License-Identifier: MIT
#include "csv.h"

#include <utility>

namespace penumbra::reproduce {

std::string csv_line(const std::vector<std::string>& values) {
  std::string line;
  for (const std::string& value : values) {
    if (&value != &values.front()) line += ',';
    if (value.find_first_of(",\"\r\n") == value.npos) {
      line += value;
      continue;
    }
    line += '"';
    for (const char c : value) line.append(c == '"' ? 2 : 1, c);
    line += '"';
  }
  return line + "\n";
}

std::vector<std::vector<std::string>> read_csv(std::string_view text) {
  std::vector<std::vector<std::string>> lines;
  std::vector<std::string> line;
  std::string value;
  bool is_quoted = false;
  const auto end_value = [&] { line.push_back(std::exchange(value, {})); };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (is_quoted) {
      if (c != '"')
        value += c;
      else if (i + 1 < text.size() && text[i + 1] == '"')
        value += text[++i];
      else
        is_quoted = false;
    } else if (c == '"') {
      is_quoted = true;
    } else if (c == ',') {
      end_value();
    } else if (c == '\n') {
      end_value();
      lines.push_back(std::exchange(line, {}));
    } else if (c != '\r') {
      value += c;
    }
  }
  if (!value.empty() || !line.empty()) {
    end_value();
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace penumbra::reproduce
