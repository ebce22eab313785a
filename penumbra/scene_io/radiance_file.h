// SPDX-License-Identifier: MIT
// A Radiance scene file as the list of its statements; nothing is looked up yet. The format: G.
// Ward, "The RADIANCE Synthetic Imaging System" (reference manual, ray.html).
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "penumbra/scene_io/source.h"

namespace penumbra {

/// `modifier type name`, then how many words, integers and numbers follow, and these.
/// Of an alias: one word, what it stands for. Of a command: one word, the line after its `!`, and
/// the type is empty.
struct RadiancePrimitive {
  std::string modifier, type, name;
  std::vector<std::string> words;
  std::vector<double> numbers;
  std::size_t line = 1;

  bool is_command() const { return type.empty(); }
};

struct RadianceFile {
  std::filesystem::path path;
  std::vector<RadiancePrimitive> statements;
};

/// Throws Error with the line of an unknown type and of arguments that are not what the counts
/// before them say.
RadianceFile parse_radiance(const Source& source);

// What kind of thing a type names. Materials, textures, patterns and mixtures are modifiers.
bool is_radiance_surface(std::string_view type);
bool is_radiance_material(std::string_view type);
bool is_radiance_mixture(std::string_view type);
bool is_radiance_pattern(std::string_view type);  ///< textures (bumps) and spectra too

/// Throws Error with the primitive's line unless it has as many numbers as `least` to `most`.
void require_numbers(const RadianceFile& file, const RadiancePrimitive& primitive,
                     std::size_t least, std::size_t most);

}  // namespace penumbra
