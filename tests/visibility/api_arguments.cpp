// SPDX-License-Identifier: MIT
#include "tests/visibility/api_arguments.h"

#include <algorithm>
#include <limits>

namespace penumbra::fuzz {
namespace {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr std::uint32_t array_count = Arrays::sane + 4;
constexpr std::uint32_t row_count = 24;  ///< of most arrays, and at least: counts often agree

float weird_number(Random& random) {
  constexpr float all[]{nan, inf, -inf, 0, -0.0f, -1, 1e15f, 2e15f, -3e38f, 1e-40f, 1e-20f, 1e9f};
  return all[random.below(std::size(all))];
}

const void* crooked(const void* data) { return static_cast<const char*>(data) + 1; }

template <class Array>
const Array& pick(const std::vector<Array>& arrays, Random& random) {
  return arrays[random.one_in(30) ? random.below(arrays.size()) : random.below(Arrays::sane)];
}

template <class Row>
penumbra_rows rows_of(const std::vector<Row>& array, Random& random) {
  return random_rows(array.data(), array.size(), sizeof(Row), random);
}

/// Sizes a little wrong are what a wrong header gives.
std::size_t struct_size(std::size_t size, Random& random) {
  if (!random.one_in(200)) return size;
  return random.one_in(2) ? random.below(300) : size + 8;
}

void put(float (&out)[3], Random& random) {
  for (float& number : out) number = random_number(random);
}

}  // namespace

Arrays::Arrays(Random& random) {
  for (std::uint32_t i = 0; i < array_count; ++i) {
    const bool is_sane = i < sane;
    const std::uint32_t count = i % 3 < 2 ? row_count : row_count + random.below(2 * row_count);
    auto& points = vectors.emplace_back();
    auto& sizes = numbers.emplace_back();
    auto& faces = triangles.emplace_back();
    for (std::uint32_t k = 0; k < count; ++k) {
      points.push_back(nasty::random_point(random));
      sizes.push_back(random.power(-2, -0.5f));
      // Few corners, so that most arrays of positions have them.
      const std::uint32_t corners = random.one_in(100) ? count : row_count;
      faces.push_back({random.below(corners), random.below(corners), random.below(corners)});
      if (is_sane || !random.one_in(4)) continue;
      const float weird = weird_number(random);
      points.back()[static_cast<int>(random.below(3))] = weird;
      sizes.back() = weird;
      faces.back()[random.below(3)] = random.one_in(2) ? ~0u : count;
    }
  }
  square = {{-1, 3, -1}, {1, 3, -1}, {1, 3, 1}, {-1, 3, 1}};
  for (int i = 0; i < 8; ++i)
    cube.push_back({i & 1 ? 1.0f : 0.5f, i & 2 ? 3.0f : 2.5f, i & 4 ? 1.0f : 0.5f});
}

penumbra_rows random_rows(const void* data, std::size_t count, std::size_t row_size,
                          Random& random) {
  const auto size = static_cast<std::ptrdiff_t>(row_size);
  if (random.one_in(100)) return {nullptr, random.below(3), size};
  if (random.one_in(200))
    return {data, std::min<std::size_t>(count, 1), std::ptrdiff_t{1} << random.below(63)};
  if (count < 2) return {data, count, 0};
  if (random.one_in(200)) return {data, SIZE_MAX >> random.below(3), 0};
  if (random.one_in(20)) {  // backwards
    const char* last = static_cast<const char*>(data) + (count - 1) * row_size;
    return {last, count, -size};
  }
  if (random.one_in(30)) return {data, (count + 1) / 2, 2 * size};
  if (random.one_in(30)) return {crooked(data), count - 1, size};
  if (random.one_in(30)) return {data, random.below(60), PENUMBRA_STRIDE_REPEAT};
  if (random.one_in(30)) return {data, count - 1, 1 + static_cast<std::ptrdiff_t>(random.below(9))};
  return {data, random.one_in(20) ? count - 1 : count, random.one_in(2) ? 0 : size};
}

penumbra_rows random_vectors(const Arrays& arrays, Random& random) {
  return rows_of(pick(arrays.vectors, random), random);
}
penumbra_rows random_numbers(const Arrays& arrays, Random& random) {
  return rows_of(pick(arrays.numbers, random), random);
}
penumbra_rows random_triangles(const Arrays& arrays, Random& random) {
  return rows_of(pick(arrays.triangles, random), random);
}

penumbra_points random_points(const Arrays& arrays, Random& random) {
  penumbra_points points{};
  points.struct_size = struct_size(sizeof points, random);
  points.positions = random_vectors(arrays, random);
  if (random.one_in(2)) points.normals = random_vectors(arrays, random);
  if (random.one_in(200)) {  // enough for several threads
    points.positions = {arrays.cube.data(), 40000, PENUMBRA_STRIDE_REPEAT};
    points.normals.count = 0;
  }
  // Of most points, and not of their number by chance alone.
  const bool is_as_long_as_said = std::max(points.positions.count, points.normals.count) < 1 << 20;
  if (is_as_long_as_said && points.normals.count && !random.one_in(10))
    points.positions.count = points.normals.count =
        std::min(points.positions.count, points.normals.count);
  if (random.one_in(10)) {
    const auto& any = arrays.vectors.front();  // 24 rows of 12 bytes hold as many keys as it takes
    points.keys = {any.data(), std::min<std::size_t>(points.positions.count, 24), 8};
  }
  points.first_key = random.below(1000);
  points.has_offset = random.one_in(3) ? 1 : random.one_in(100) ? 2 : 0;
  points.offset = random.one_in(10) ? weird_number(random) : random.power(-6, -1);
  return points;
}

penumbra_light random_light(const Arrays& arrays, Random& random) {
  penumbra_light light{};
  light.struct_size = struct_size(sizeof light, random);
  light.kind = random.one_in(100) ? random.below(100) : 1 + random.below(8);
  put(light.center, random);
  if (!random.one_in(4)) light.center[1] += 2;
  put(light.u, random);
  put(light.v, random);
  light.radius = random.one_in(30) ? weird_number(random) : random.power(-3, 0.5f);
  light.diameter_deg = random.one_in(30) ? weird_number(random) : random.uniform(0, 30);
  if (random.one_in(10))
    light.corners = random_vectors(arrays, random);
  else
    light.corners =
        rows_of(light.kind == PENUMBRA_LIGHT_POLYGON ? arrays.square : arrays.cube, random);
  return light;
}

penumbra_ask_options random_options(Random& random) {
  penumbra_ask_options options{};
  options.struct_size = struct_size(sizeof options, random);
  constexpr std::uint32_t edges[]{0, 1, 32, 33, 65536, 65537, 0x80000000u, ~0u};
  options.shadow_samples =
      random.one_in(30) ? edges[random.below(std::size(edges))] : 1 + random.below(70);
  options.method = random.one_in(100) ? random.below(10) : random.below(2);
  options.light_index = random.one_in(10) ? ~0u : random.below(3);
  options.keys_are_final = random.one_in(200) ? 2 : random.one_in(10);
  constexpr std::uint32_t threads[]{0, 1, 2, 3, 100, 1000000, 0x7fffffffu, 0x80000000u, ~0u};
  options.threads = random.one_in(30) ? threads[random.below(std::size(threads))] : random.below(3);
  return options;
}

std::array<double, 12> random_placement(Random& random) {
  std::array<double, 12> placement{};
  const double scale = random.one_in(4) ? double(random.power(-2, 1)) : 1;
  const bool is_sheared = random.one_in(4);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) {
      double& number = placement[static_cast<std::size_t>(4 * row + column)];
      if (column == 3 || is_sheared) number = double(random.uniform(-1, 1));
      if (row == column) number += scale;
    }
  if (random.one_in(30)) placement[random.below(12)] = double(weird_number(random));
  return placement;
}

float random_number(Random& random) {
  return random.one_in(200) ? weird_number(random) : random.uniform(-1, 1);
}

}  // namespace penumbra::fuzz
