// SPDX-License-Identifier: MIT
// Which triangles of a scene lie where in a texture.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "penumbra/scene/scene.h"
#include "penumbra/trace/footprint.h"

namespace penumbra {

/// Of a mesh's two sets of texture coordinates: `uvs` and `lightmap_uvs`.
enum class UvSet { first, second };

inline const std::vector<Vec2f>& uvs_of(const Mesh& mesh, UvSet set) {
  return set == UvSet::first ? mesh.uvs : mesh.lightmap_uvs;
}

/// Triangle `triangle` of the scene's mesh `mesh`.
struct AtlasTriangle {
  std::uint32_t mesh = 0, triangle = 0;
};

/// Triangles that cannot be baked, in whole or in part.
struct UvFaults {
  std::uint64_t flat = 0;        ///< without area in the texture
  std::uint64_t not_finite = 0;  ///< coordinates that are not finite, or beyond 1000
  std::uint64_t outside = 0;     ///< reach out of [0, 1], by more than 1e-4: cut off there

  void add(const UvFaults& other) {
    flat += other.flat, not_finite += other.not_finite, outside += other.outside;
  }
};

/// Blocks of `block_edge` squared texels, row by row, with the triangles that reach into them.
struct UvAtlas {
  std::uint32_t width = 0, height = 0;
  UvSet set = UvSet::first;
  std::vector<AtlasTriangle> triangles;  ///< block after block
  std::vector<std::size_t> begin;        ///< of each block in `triangles`, and the end
  std::uint64_t triangle_count = 0;      ///< of the meshes
  UvFaults faults;

  std::size_t block_count() const { return begin.size() - 1; }
  std::span<const AtlasTriangle> block(std::size_t index) const {
    return std::span(triangles).subspan(begin[index], begin[index + 1] - begin[index]);
  }
};

/// Meshes that lack the set are left out; indices must be in range. Throws Error where no triangle
/// has a place in the texture, and where they would cover it 64 times over or more: charts of
/// lightmaps lie side by side. Cost: linear in triangles and the blocks that they reach.
UvAtlas make_atlas(const Scene& scene, std::span<const std::uint32_t> meshes, UvSet set,
                   std::uint32_t width, std::uint32_t height);

/// Where it lies in a texture of this size. The texture's top row of texels is at v = 1.
TexelTriangle texel_triangle(const Scene& scene, const UvAtlas& atlas, AtlasTriangle triangle);

}  // namespace penumbra
