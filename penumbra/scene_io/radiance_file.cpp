// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/radiance_file.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "penumbra/scene_io/numbers.h"
#include "penumbra/scene_io/radiance_words.h"

namespace penumbra {
namespace {

constexpr std::array<std::string_view, 11> surfaces{"source", "sphere",   "bubble", "polygon",
                                                    "cone",   "cup",      "ring",   "cylinder",
                                                    "tube",   "instance", "mesh"};
constexpr std::array<std::string_view, 29> materials{
    "light",     "illum",   "glow",      "spotlight",  "mirror",    "prism1",
    "prism2",    "mist",    "plastic",   "metal",      "trans",     "plastic2",
    "metal2",    "trans2",  "ashik2",    "dielectric", "interface", "glass",
    "plasfunc",  "metfunc", "transfunc", "BRTDfunc",   "plasdata",  "metdata",
    "transdata", "BSDF",    "aBSDF",     "antimatter", "WGMDfunc"};
constexpr std::array<std::string_view, 4> mixtures{"mixfunc", "mixdata", "mixpict", "mixtext"};
constexpr std::array<std::string_view, 14> patterns{
    "texfunc",   "texdata",    "colorfunc", "brightfunc", "colordata", "brightdata", "colorpict",
    "colortext", "brighttext", "spectrum",  "specfile",   "specfunc",  "specdata",   "specpict"};

template <std::size_t n>
bool holds(const std::array<std::string_view, n>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_known(std::string_view type) {
  return is_radiance_surface(type) || is_radiance_material(type) || is_radiance_mixture(type) ||
         is_radiance_pattern(type);
}

std::string take(RadianceWords& words, std::string_view what) {
  const Token token = words.next();
  if (token.text.empty()) words.fail(token, what);
  return std::string(token.text);
}

void read_arguments(RadianceWords& words, RadiancePrimitive& p) {
  const auto what = [&](const char* kind) {
    return fmt::format("{} of {} {}", kind, p.type, in_quotes(p.name));
  };
  const std::size_t word_count = words.count(what("the number of words"));
  for (std::size_t i = 0; i < word_count; ++i) p.words.push_back(take(words, what("a word")));
  const std::size_t integers = words.count(what("the number of integers"));
  for (std::size_t i = 0; i < integers; ++i) words.number(what("an integer"));
  const std::size_t numbers = words.count(what("the number of numbers"));
  const std::string number = what("a number");
  p.numbers.reserve(numbers);
  for (std::size_t i = 0; i < numbers; ++i) p.numbers.push_back(words.number(number));
}

RadiancePrimitive read_primitive(RadianceWords& words, const Token& modifier) {
  RadiancePrimitive p;
  p.modifier = modifier.text;
  p.line = modifier.line;
  const Token type = words.next();
  if (type.text.empty()) words.fail(type, "a type after the modifier");
  p.type = type.text;
  if (p.type != "alias" && !is_known(p.type))
    throw Error(words.place(type),
                fmt::format("{} is no type that Radiance has", in_quotes(p.type)),
                "a primitive is `modifier type name` and three lists of arguments, each after its "
                "length");
  p.name = take(words, "a name");
  if (p.type == "alias")
    p.words.push_back(take(words, "what the alias stands for"));
  else
    read_arguments(words, p);
  return p;
}

}  // namespace

bool is_radiance_surface(std::string_view type) { return holds(surfaces, type); }
bool is_radiance_material(std::string_view type) { return holds(materials, type); }
bool is_radiance_mixture(std::string_view type) { return holds(mixtures, type); }
bool is_radiance_pattern(std::string_view type) { return holds(patterns, type); }

RadianceFile parse_radiance(const Source& source) {
  RadianceFile file;
  file.path = source.path;
  RadianceWords words(source.path.string(), source.bytes);
  for (;;) {
    if (words.at_command()) {
      RadiancePrimitive command;
      command.line = words.line();
      command.words.push_back(words.command());
      file.statements.push_back(std::move(command));
      continue;
    }
    const Token modifier = words.next();
    if (modifier.text.empty()) return file;
    file.statements.push_back(read_primitive(words, modifier));
  }
}

void require_numbers(const RadianceFile& file, const RadiancePrimitive& p, std::size_t least,
                     std::size_t most) {
  if (p.numbers.size() >= least && p.numbers.size() <= most) return;
  throw Error(
      {file.path.string(), p.line, {}},
      fmt::format("{} {} has {} numbers, not {}{}", p.type, in_quotes(p.name), p.numbers.size(),
                  least, most == least ? "" : fmt::format(" to {}", most)),
      "see Radiance's manual for what they are");
}

}  // namespace penumbra
