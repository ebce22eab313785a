// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/read_mtl.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "penumbra/scene_io/numbers.h"
#include "penumbra/scene_io/text_lines.h"

namespace penumbra {

namespace {

/// A material's statements as they stand, before our model is made of them.
struct Statements {
  std::string name;
  Color kd{0.8f, 0.8f, 0.8f}, ks, ke;
  std::optional<Color> tf;
  float ns = 0, dissolve = 1, ni = 1;
  bool has_dissolve = false;  // d beats Tr, which some exporters write the other way round
  int illum = 2;
  std::int32_t texture = -1;
};

struct MtlReader {
  const std::string& file;
  TextureLoader& textures;
  Warnings& warnings;
  std::size_t line = 0;

  float number(std::string_view word) const {
    const auto value = parse_float(word);
    if (!value || !std::isfinite(*value))
      throw Error({file, line, {}}, fmt::format("{} is not a finite number", in_quotes(word)),
                  "mend the material");
    return *value;
  }
};

/// Three numbers, or one for all three; nothing for spectral curves and the like.
std::optional<Color> color(const MtlReader& reader, std::string_view rest) {
  const std::string_view first = next_word(rest);
  if (first == "spectral" || first == "xyz") return std::nullopt;
  const float r = reader.number(first);
  const std::string_view second = next_word(rest);
  const float g = second.empty() ? r : reader.number(second);
  const std::string_view third = next_word(rest);
  const float b = second.empty() ? r : reader.number(third);
  return max(Color{r, g, b}, Color{});
}

/// A map's file name: all that follows its options, spaces included.
std::string_view map_file(std::string_view rest) {
  while (true) {
    std::string_view after = rest;
    const std::string_view word = next_word(after);
    if (word.size() < 2 || word[0] != '-') return trimmed(rest);
    rest = after;
    if (word == "-o" || word == "-s" || word == "-t") {  // one to three numbers
      for (int i = 0; i < 3; ++i) {
        std::string_view tail = rest;
        if (!parse_float(next_word(tail))) break;
        rest = tail;
      }
      continue;
    }
    next_word(rest);
    if (word == "-mm") next_word(rest);
  }
}

Material to_material(const Statements& s) {
  const bool is_glass = s.illum == 4 || s.illum == 6 || s.illum == 7 || s.illum == 9;
  Material m;
  m.name = s.name;
  m.texture = s.texture;
  // Exporters leave Kd black where a map replaces it; our texture multiplies it.
  const bool is_replaced = s.texture >= 0 && s.kd == Color{};
  m.diffuse = (is_replaced ? Color{1, 1, 1} : s.kd) * s.dissolve;
  m.emission = s.ke;
  if (s.illum >= 2 && s.ns > 0) {
    m.highlight = s.ks;
    m.shininess = s.ns;
  }
  if (s.illum >= 3 && s.illum <= 8) m.mirror = s.ks;
  const Color filter = is_glass ? s.tf.value_or(Color{1, 1, 1}) : Color{1, 1, 1};
  // Many exporters write Tf 1 1 1 for everything: alone it means something for glass only.
  const bool is_clear = is_glass && s.tf && s.dissolve == 1;
  m.transmission = filter * (is_clear ? 1.0f : 1 - s.dissolve);
  if (is_glass && s.ni > 0) m.refraction_index = s.ni;
  return m;
}

void read_statement(MtlReader& reader, std::string_view keyword, std::string_view rest,
                    Statements& s) {
  const auto one = [&] { return reader.number(next_word(rest)); };
  const auto unread = [&] {
    reader.warnings.add(fmt::format("materials: {} is not read", in_quotes(keyword)));
  };
  const auto three = [&](Color& target) {
    if (const auto value = color(reader, rest))
      target = *value;
    else
      unread();
  };
  if (keyword == "Kd") return three(s.kd);
  if (keyword == "Ks") return three(s.ks);
  if (keyword == "Ke") return three(s.ke);
  if (keyword == "Tf") {
    s.tf = color(reader, rest);
    return;
  }
  if (keyword == "Ns") {
    s.ns = std::clamp(one(), 0.0f, 1e6f);
  } else if (keyword == "Ni") {
    s.ni = one();
  } else if (keyword == "d") {
    if (rest.find("-halo") != std::string_view::npos) return unread();
    s.dissolve = std::clamp(one(), 0.0f, 1.0f);
    s.has_dissolve = true;
  } else if (keyword == "Tr") {
    const float transparency = std::clamp(one(), 0.0f, 1.0f);
    if (!s.has_dissolve) s.dissolve = 1 - transparency;
  } else if (keyword == "illum") {
    s.illum = static_cast<int>(std::clamp(one(), 0.0f, 10.0f));
  } else if (keyword == "map_Kd") {
    s.texture = reader.textures.from_file(map_file(rest));
  } else if (keyword != "Ka" &&
             keyword != "sharpness") {  // harmless: we have no ambient of surfaces
    unread();
  }
}

}  // namespace

std::vector<Material> read_mtl(std::string_view text, const std::string& file,
                               TextureLoader& textures, Warnings& warnings) {
  MtlReader reader{file, textures, warnings};
  std::vector<Material> materials;
  std::optional<Statements> current;
  const auto finish = [&] {
    if (current) materials.push_back(to_material(*current));
  };
  TextLines lines(text, LineJoints::backslash);
  while (auto line = lines.next()) {
    reader.line = lines.number();
    std::string_view rest = *line;
    const std::string_view keyword = next_word(rest);
    if (keyword.empty()) continue;
    if (keyword == "newmtl") {
      finish();
      current = Statements{};
      current->name = trimmed(rest);
    } else if (current) {
      read_statement(reader, keyword, rest, *current);
    } else {
      throw Error({file, reader.line, {}},
                  fmt::format("{} stands before any newmtl", in_quotes(keyword)),
                  "begin each material with newmtl");
    }
  }
  finish();
  return materials;
}

}  // namespace penumbra
