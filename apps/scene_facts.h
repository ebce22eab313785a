// SPDX-License-Identifier: MIT
// What `info` tells about a scene, as text or JSON.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "penumbra/scene/scene.h"

namespace penumbra {

struct MeshFacts {
  std::size_t vertices = 0, triangles = 0;
  std::size_t closed_components = 0, open_components = 0;
  std::size_t closed_triangles = 0;  ///< of closed components; the rest is of open ones
  std::size_t boundary_edges = 0, nonmanifold_edges = 0;
  bool has_normals = false, is_backdrop = false;
};

/// What may prove umbra behind meshes: see closed_surface.h.
struct SolidFacts {
  std::size_t closed = 0, filled = 0;      ///< surfaces without holes, and with
  std::size_t fills = 0;                   ///< triangles that fill holes
  std::size_t triangles = 0, largest = 0;  ///< of all, and of the one with most
};

struct SceneFacts {
  // The set's own, and those of groups once each; `primitives` counts the latter as often as they
  // are placed.
  std::size_t spheres = 0, cylinders = 0, cones = 0, rings = 0, triangles = 0, primitives = 0;
  std::size_t groups = 0, instances = 0, placed = 0;  ///< primitives that instances place
  std::vector<MeshFacts> meshes;
  MeshFacts all_meshes;  ///< sums
  SolidFacts solids;
  Box bounds, object_bounds;
  double load_seconds = 0, build_seconds = 0;
  std::size_t memory_bytes = 0;      ///< of the ray kernel
  std::uint64_t peak_rss_bytes = 0;  ///< of the whole process
};

/// The scene as its file has it, before `complete_scene`. Cost: that of `topology` for each mesh,
/// and of `closed_surfaces`.
SceneFacts scene_facts(const Scene& scene);

std::string to_text(const SceneFacts& facts, const Scene& scene);
std::string to_json(const SceneFacts& facts, const Scene& scene);

}  // namespace penumbra
