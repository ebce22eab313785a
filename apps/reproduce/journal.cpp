// SPDX-License-Identifier: MIT
#include "journal.h"

#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <sstream>
#include <string_view>
#include <type_traits>
#include <utility>

#include "csv.h"
#include "penumbra/scene/error.h"
#include "penumbra/scene_io/write_scene.h"

namespace penumbra::reproduce {
namespace {

/// With what a row was measured; every row says it, so that rows of several machines can be joined.
std::vector<std::pair<std::string, std::string>> provenance(const Machine& m,
                                                            const std::string& run) {
  return {{"run", run},
          {"version", m.version},
          {"compiler", m.compiler},
          {"flags", m.flags},
          {"cpu", m.cpu},
          {"cores", std::to_string(m.cores)},
          {"instruction_set", m.instruction_set},
          {"embree", m.embree}};
}

template <class Value>
std::string to_text(const Value& value) {
  if constexpr (std::is_same_v<Value, std::string>)
    return value;
  else
    return fmt::format("{}", value);  // shortest that reads back to the same bits
}

template <class Value>
bool read(const std::string& text, Value& value) {
  if constexpr (std::is_same_v<Value, std::string>) {
    value = text;
    return true;
  } else {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
  }
}

std::vector<std::string> header(const Machine& machine, const std::string& run) {
  std::vector<std::string> names;
  const Measurement any;
  each_field(any, [&](const char* name, const auto&) { names.push_back(name); });
  for (const auto& [name, value] : provenance(machine, run)) names.push_back(name);
  return names;
}

}  // namespace

Journal::Journal(std::filesystem::path path, Machine machine, std::string run)
    : path_(std::move(path)), machine_(std::move(machine)), run_(std::move(run)) {
  std::ifstream file(path_, std::ios::binary);
  if (!file) return;
  std::ostringstream text;
  text << file.rdbuf();
  std::string_view lines = text.view();
  lines = lines.substr(0, lines.rfind('\n') + 1);  // without what was cut off
  const std::vector<std::vector<std::string>> rows = read_csv(lines);
  const std::vector<std::string> names = header(machine_, run_);
  const auto expected = provenance(machine_, run_);
  const auto refuse = [&](const std::string& why) {
    throw Error({path_.string(), {}, {}}, why, "choose another folder with -o, or remove the file");
  };
  if (!rows.empty() && rows.front() != names)
    refuse("is not a journal of this version's measurements");
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].size() != names.size()) continue;
    Measurement m;
    std::size_t column = 0;
    bool is_good = true;
    each_field(m, [&](const char*, auto& value) { is_good &= read(rows[i][column++], value); });
    for (const auto& [name, value] : expected)
      if (const std::string& found = rows[i][column++]; is_good && found != value)
        refuse(fmt::format("holds measurements of another run ({} is {}, now {})", name, found,
                           value));
    if (is_good) measurements_.push_back(std::move(m));
  }
}

const Measurement* Journal::find(const Setting& setting, const std::string& method) const {
  for (const Measurement& m : measurements_)
    if (m.setting == setting && m.row.method == method) return &m;
  return nullptr;
}

void Journal::add(std::vector<Measurement> measured) {
  for (const Measurement& m : measured)
    std::erase_if(measurements_, [&](const Measurement& old) {
      return old.setting == m.setting && old.row.method == m.row.method;
    });
  for (Measurement& m : measured) {
    m.program = machine_.program;
    measurements_.push_back(std::move(m));
  }
  std::string text = csv_line(header(machine_, run_));
  for (const Measurement& m : measurements_) {
    std::vector<std::string> values;
    each_field(m, [&](const char*, const auto& value) { values.push_back(to_text(value)); });
    for (const auto& [name, value] : provenance(machine_, run_)) values.push_back(value);
    text += csv_line(values);
  }
  write_file(path_, text);
}

}  // namespace penumbra::reproduce
