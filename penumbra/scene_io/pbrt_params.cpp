// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/pbrt_params.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "penumbra/scene_io/numbers.h"

namespace penumbra {
namespace {

/// Of one directive: names are looked up one by one.
constexpr std::size_t most_parameters = 256;

enum class Values { numbers, flags, texts, spectrum };

struct Type {
  std::string_view name;
  Values values;
};

constexpr std::array types{Type{"float", Values::numbers},    Type{"integer", Values::numbers},
                           Type{"bool", Values::flags},       Type{"string", Values::texts},
                           Type{"texture", Values::texts},    Type{"point", Values::numbers},
                           Type{"point2", Values::numbers},   Type{"point3", Values::numbers},
                           Type{"vector", Values::numbers},   Type{"vector2", Values::numbers},
                           Type{"vector3", Values::numbers},  Type{"normal", Values::numbers},
                           Type{"normal3", Values::numbers},  Type{"rgb", Values::numbers},
                           Type{"color", Values::numbers},    Type{"blackbody", Values::numbers},
                           Type{"spectrum", Values::spectrum}};

/// "type name" of a declaration.
std::pair<std::string, std::string> split(const PbrtToken& token) {
  const std::string_view words = token.text;
  const auto skip = [&](std::size_t at) {
    return std::min(words.find_first_not_of(" \t", at), words.size());
  };
  const std::size_t type_at = skip(0);
  const std::size_t type_end = std::min(words.find_first_of(" \t", type_at), words.size());
  const std::size_t name_at = skip(type_end);
  const std::size_t name_end = std::min(words.find_first_of(" \t", name_at), words.size());
  if (name_at == name_end || skip(name_end) != words.size())
    throw Error(token.place, "expected a parameter's type and name, found " + in_quotes(words),
                "write them as \"float radius\"");
  return {std::string(words.substr(type_at, type_end - type_at)),
          std::string(words.substr(name_at, name_end - name_at))};
}

Values values_of(const std::string& type, PbrtPlace place) {
  for (const Type& known : types)
    if (known.name == type) return known.values;
  throw Error(place, "unknown parameter type " + in_quotes(type),
              "pbrt-v4 has float, integer, bool, string, point2, point3, vector2, vector3, normal, "
              "rgb, blackbody, spectrum and texture");
}

void add_value(PbrtParameter& parameter, Values values, const PbrtToken& token) {
  const bool is_text = token.kind == PbrtTokenKind::text;
  if (values == Values::flags) {
    if (token.text != "true" && token.text != "false") fail_pbrt_token(token, "true or false");
    parameter.numbers.push_back(token.text == "true" ? 1 : 0);
  } else if (values == Values::texts || (values == Values::spectrum && is_text)) {
    if (!is_text) fail_pbrt_token(token, "a text in quotation marks");
    parameter.texts.emplace_back(token.text);
  } else {
    parameter.numbers.push_back(
        pbrt_number(token, fmt::format("a number of `{:.40}`", parameter.name)));
  }
}

/// Checks the type of a parameter, and that its numbers come in groups of this size.
void require(const PbrtParameter& parameter, std::span<const std::string_view> allowed,
             std::size_t group) {
  if (std::find(allowed.begin(), allowed.end(), parameter.type) == allowed.end())
    throw Error(parameter.place,
                fmt::format("parameter {} is of the type {}", in_quotes(parameter.name),
                            in_quotes(parameter.type)),
                fmt::format("it must be {}", allowed[0]));
  if (group > 0 && parameter.numbers.size() % group != 0)
    throw Error(parameter.place,
                fmt::format("parameter {} has {} numbers, which do not come in {}s",
                            in_quotes(parameter.name), parameter.numbers.size(),
                            group == 2 ? "pair" : "three"),
                "the list may be cut off");
}

void require_one(const PbrtParameter& parameter, std::size_t found, std::size_t wanted) {
  if (found != wanted)
    throw Error(parameter.place, fmt::format("parameter {} has {} values instead of {}",
                                             in_quotes(parameter.name), found, wanted));
}

constexpr std::string_view float_types[] = {"float", "integer"};
constexpr std::string_view triple_types[] = {"point3", "point",  "vector3",
                                             "vector", "normal", "normal3"};
constexpr std::string_view pair_types[] = {"point2", "vector2", "float"};
constexpr std::string_view flag_types[] = {"bool"}, text_types[] = {"string"},
                           index_types[] = {"integer"};

}  // namespace

PbrtParams PbrtParams::read(PbrtTokens& tokens, PbrtPlace directive) {
  PbrtParams params;
  params.place_ = directive;
  while (tokens.peek().kind == PbrtTokenKind::text) {
    const PbrtToken declaration = tokens.next();
    auto [type, name] = split(declaration);
    const Values values = values_of(type, declaration.place);
    PbrtParameter parameter{std::move(type), std::move(name), {}, {}, declaration.place};
    PbrtToken token = tokens.next();
    if (token.kind == PbrtTokenKind::open) {
      for (token = tokens.next(); token.kind != PbrtTokenKind::close; token = tokens.next())
        add_value(parameter, values, token);
    } else {
      add_value(parameter, values, token);
    }
    if (params.find_own(parameter.name))
      throw Error(parameter.place, "parameter " + in_quotes(parameter.name) + " is given twice");
    if (params.entries_.size() == most_parameters)
      throw Error(parameter.place, fmt::format("more than {} parameters", most_parameters));
    params.entries_.push_back({std::move(parameter), false});
  }
  for (const Entry& entry : params.entries_) entry.was_read = false;
  return params;
}

PbrtParams PbrtParams::with_defaults(const PbrtParams* others) const {
  constexpr std::size_t most_values = 64;
  PbrtParams both = *this;
  if (others)
    for (const Entry& entry : others->entries_)
      if (!find_own(entry.parameter.name)) both.entries_.push_back(entry);
  for (const Entry& entry : both.entries_) {
    entry.was_read = true;
    if (entry.parameter.numbers.size() + entry.parameter.texts.size() > most_values ||
        both.entries_.size() > most_parameters)
      throw Error(
          entry.parameter.place,
          fmt::format("Attribute gives more than {} parameters, or one of more than {} values",
                      most_parameters, most_values),
          "give them to the shapes themselves");
  }
  return both;
}

const PbrtParameter* PbrtParams::find_own(std::string_view name) const {
  for (const Entry& entry : entries_)
    if (entry.parameter.name == name) {
      entry.was_read = true;
      return &entry.parameter;
    }
  return nullptr;
}

const PbrtParameter* PbrtParams::find(std::string_view name) const {
  const PbrtParameter* own = find_own(name);
  return own || !defaults_ ? own : defaults_->find_own(name);
}

double PbrtParams::number(std::string_view name, double otherwise) const {
  const PbrtParameter* p = find(name);
  if (!p) return otherwise;
  require(*p, float_types, 0);
  require_one(*p, p->numbers.size(), 1);
  return p->numbers[0];
}

bool PbrtParams::flag(std::string_view name, bool otherwise) const {
  const PbrtParameter* p = find(name);
  if (!p) return otherwise;
  require(*p, flag_types, 0);
  require_one(*p, p->numbers.size(), 1);
  return p->numbers[0] != 0;
}

std::string PbrtParams::text(std::string_view name, std::string_view otherwise) const {
  const PbrtParameter* p = find(name);
  if (!p) return std::string(otherwise);
  require(*p, text_types, 0);
  require_one(*p, p->texts.size(), 1);
  return p->texts[0];
}

Vec3d PbrtParams::point(std::string_view name, Vec3d otherwise) const {
  const PbrtParameter* p = find(name);
  if (!p) return otherwise;
  require(*p, triple_types, 3);
  require_one(*p, p->numbers.size(), 3);
  return {p->numbers[0], p->numbers[1], p->numbers[2]};
}

std::vector<double> PbrtParams::numbers(std::string_view name) const {
  const PbrtParameter* p = find(name);
  if (!p) return {};
  require(*p, float_types, 0);
  return p->numbers;
}

std::vector<Vec3f> PbrtParams::points(std::string_view name) const {
  const PbrtParameter* p = find(name);
  if (!p) return {};
  require(*p, triple_types, 3);
  std::vector<Vec3f> points;
  points.reserve(p->numbers.size() / 3);
  for (std::size_t i = 0; i < p->numbers.size(); i += 3)
    points.push_back(Vec3f(Vec3d(p->numbers[i], p->numbers[i + 1], p->numbers[i + 2])));
  return points;
}

std::vector<Vec2f> PbrtParams::pairs(std::string_view name) const {
  const PbrtParameter* p = find(name);
  if (!p) return {};
  require(*p, pair_types, 2);
  std::vector<Vec2f> pairs;
  for (std::size_t i = 0; i < p->numbers.size(); i += 2)
    pairs.push_back({static_cast<float>(p->numbers[i]), static_cast<float>(p->numbers[i + 1])});
  return pairs;
}

std::vector<std::string> PbrtParams::texts(std::string_view name) const {
  const PbrtParameter* p = find(name);
  if (!p) return {};
  require(*p, text_types, 0);
  return p->texts;
}

std::vector<std::uint32_t> PbrtParams::indices(std::string_view name, std::size_t end) const {
  const PbrtParameter* p = find(name);
  if (!p) return {};
  require(*p, index_types, 0);
  std::vector<std::uint32_t> indices;
  indices.reserve(p->numbers.size());
  for (const double number : p->numbers) {
    if (!(number >= 0 && number < static_cast<double>(end) && number == std::floor(number)))
      throw Error(p->place,
                  fmt::format("parameter {} names vertex {}, but there are {}", in_quotes(p->name),
                              number, end),
                  "number vertices from 0");
    indices.push_back(static_cast<std::uint32_t>(number));
  }
  return indices;
}

std::vector<const PbrtParameter*> PbrtParams::unread() const {
  std::vector<const PbrtParameter*> unread;
  for (const Entry& entry : entries_)
    if (!entry.was_read) unread.push_back(&entry.parameter);
  return unread;
}

}  // namespace penumbra
