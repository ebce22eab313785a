// SPDX-License-Identifier: MIT
// Random arguments for the C API: mostly what can be meant, and all that cannot.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <vector>

#include "penumbra/penumbra_c.h"
#include "tests/kernel/nasty_shapes.h"

namespace penumbra::fuzz {

using nasty::Random;

/// Changes in place; one thread's own.
struct MovingMesh {
  std::vector<Vec3f> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// What calls hand over. Nothing of it but what moves ever changes.
struct Arrays {
  explicit Arrays(Random& random);

  /// The first `sane` of each can be meant.
  static constexpr std::uint32_t sane = 6;
  std::vector<std::vector<Vec3f>> vectors;
  std::vector<std::vector<float>> numbers;
  std::vector<std::vector<std::array<std::uint32_t, 3>>> triangles;
  std::vector<Vec3f> square, cube;
  std::deque<MovingMesh> moving;
};

/// Rows of an array, whole, in part, backwards or crooked; rarely, NULL or endless.
penumbra_rows random_rows(const void* data, std::size_t count, std::size_t row_size,
                          Random& random);

/// Of an array that can be meant, but rarely.
penumbra_rows random_vectors(const Arrays& arrays, Random& random);
penumbra_rows random_numbers(const Arrays& arrays, Random& random);
penumbra_rows random_triangles(const Arrays& arrays, Random& random);

penumbra_points random_points(const Arrays& arrays, Random& random);
penumbra_light random_light(const Arrays& arrays, Random& random);
/// Without progress.
penumbra_ask_options random_options(Random& random);
std::array<double, 12> random_placement(Random& random);
/// Rarely none.
float random_number(Random& random);

}  // namespace penumbra::fuzz
