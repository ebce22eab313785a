// SPDX-License-Identifier: MIT
// Lights in words, the same in NFF's "#! light" and in `--light`:
//   point x y z | sphere cx cy cz r | rect cx cy cz ux uy uz vx vy vz | disk cx cy cz nx ny nz r |
//   line ax ay az bx by bz | polygon n x y z ... | mesh n x y z ... | sun dx dy dz degrees
// each with an optional "r g b" at the end, the linear intensity. `rect` has half edges; a polygon
// its n corners in order; a mesh is the convex hull of n points; the sun's direction is towards it,
// its degrees are its angular diameter. After that, except for suns, an optional
//   beam ax ay az full_deg none_deg
// along an axis: full light up to the first angle from it, none from the second on.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "penumbra/scene/light.h"

namespace penumbra {

struct LightSpec {
  LightShape shape;
  std::optional<Color> intensity;  ///< as given
  std::optional<Beam> beam;
};

/// Throws Error, without a place, that says what is wrong with the words and what would be right.
LightSpec parse_light_spec(std::span<const std::string> words);

/// The same as a light without falloff, of intensity 1 unless given.
Light parse_light(std::span<const std::string> words);

/// What follows the word `beam`, for a light of this shape. Throws like `parse_light_spec`.
Beam parse_beam(std::span<const std::string> words, const LightShape& light);

/// The words of a line.
std::vector<std::string> split_words(std::string_view text);

/// Words that `parse_light` reads back to the same bits; the falloff is not part of them, and
/// neither are the centres of polygons and the triangles of meshes, which follow from the corners.
/// (Lines: the same bits where centre + half is exact in double, which has some 29 bits to spare.)
std::string light_words(const Light& light);

/// The same for `parse_beam`, where the cosines are 0 or at least 1e-12.
std::string beam_words(const Beam& beam);

}  // namespace penumbra
