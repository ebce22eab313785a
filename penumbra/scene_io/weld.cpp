// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/weld.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace penumbra {
namespace {

/// The bits of a vertex, first mixed into one number: most comparisons end there.
struct Key {
  std::uint64_t hash = 0;
  std::array<std::uint32_t, 6> bits{};
  std::uint32_t index = 0;
};

Key key_of(const Mesh& mesh, std::uint32_t index) {
  Key key;
  key.index = index;
  for (int axis = 0; axis < 3; ++axis) {
    key.bits[axis] = std::bit_cast<std::uint32_t>(mesh.positions[index][axis]);
    if (!mesh.normals.empty())
      key.bits[axis + 3] = std::bit_cast<std::uint32_t>(mesh.normals[index][axis]);
  }
  for (const std::uint32_t word : key.bits) {
    key.hash = (key.hash ^ word) * 0x9E3779B97F4A7C15u;
    key.hash ^= key.hash >> 32;
  }
  return key;
}

bool less(const Key& a, const Key& b) {
  if (a.hash != b.hash) return a.hash < b.hash;
  return a.bits != b.bits ? a.bits < b.bits : a.index < b.index;
}

/// For each vertex the first one that equals it.
std::vector<std::uint32_t> first_equals(const Mesh& mesh) {
  const auto count = static_cast<std::uint32_t>(mesh.positions.size());
  std::vector<Key> keys(count);
  for (std::uint32_t i = 0; i < count; ++i) keys[i] = key_of(mesh, i);
  std::sort(keys.begin(), keys.end(), less);
  std::vector<std::uint32_t> first(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const bool repeats = i > 0 && keys[i].bits == keys[i - 1].bits;
    first[keys[i].index] = repeats ? first[keys[i - 1].index] : keys[i].index;
  }
  return first;
}

}  // namespace

void weld(Mesh& mesh) {
  std::vector<std::uint32_t> place = first_equals(mesh);
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < place.size(); ++i) {
    if (place[i] != i) {
      place[i] = place[place[i]];
      continue;
    }
    mesh.positions[kept] = mesh.positions[i];
    if (!mesh.normals.empty()) mesh.normals[kept] = mesh.normals[i];
    place[i] = kept++;
  }
  mesh.positions.resize(kept);
  if (!mesh.normals.empty()) mesh.normals.resize(kept);
  for (Triangle& triangle : mesh.triangles)
    for (std::uint32_t& corner : triangle) corner = place[corner];
}

}  // namespace penumbra
