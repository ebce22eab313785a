// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/faces.h"

#include <limits>
#include <string>
#include <vector>

#include "penumbra/geometry/polygon.h"

namespace penumbra {

void check_vertex_count(const Error::Place& place, std::size_t vertices) {
  if (vertices >= std::numeric_limits<std::uint32_t>::max())
    throw Error(place, "more vertices than 32 bits can number", "split the mesh");
}

void append_face(Mesh& mesh, std::span<const std::uint32_t> corners) {
  if (corners.size() == 3) {
    mesh.triangles.push_back({corners[0], corners[1], corners[2]});
    return;
  }
  std::vector<Vec3f> positions;
  positions.reserve(corners.size());
  for (const std::uint32_t corner : corners) positions.push_back(mesh.positions[corner]);
  for (const Triangle& t : triangulate(positions))
    mesh.triangles.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
}

}  // namespace penumbra
