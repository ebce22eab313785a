// SPDX-License-Identifier: MIT
// From a caller's arrays to shapes that have been checked, and back to his numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "penumbra/geometry/shape.h"
#include "penumbra/visibility/description.h"
#include "penumbra/visibility/occluders.h"

namespace penumbra {

/// What the shapes of one set are called.
struct ShapeNames {
  /// Shapes of a kind from `first` on, up to the next run, are those of a geometry.
  struct Run {
    std::uint32_t first = 0, geometry = 0;
    bool operator==(const Run&) const = default;
  };
  std::vector<Run> runs[3];  ///< of spheres, cones, rings
  /// One mesh. `kept`: the caller's numbers of its triangles, where some were degenerate and went;
  /// empty: all are there.
  struct MeshName {
    std::uint32_t geometry = 0;
    std::vector<std::uint32_t> kept;
    bool operator==(const MeshName&) const = default;
  };
  std::vector<MeshName> meshes;

  bool operator==(const ShapeNames&) const = default;
};

/// The same for all of a description.
struct OccluderNames {
  struct InstanceName {
    std::uint32_t number = 0;
    std::uint32_t group = 0;  ///< of the shapes'
    bool operator==(const InstanceName&) const = default;
  };
  ShapeNames own;
  std::vector<ShapeNames> groups;
  std::vector<InstanceName> instances;

  bool operator==(const OccluderNames&) const = default;
};

struct GatheredShapes {
  ShapeSet shapes;
  OccluderNames names;
  std::size_t degenerate_triangles = 0;
};

/// Reads the arrays. Groups that nothing places, and what holds nothing, are left out. Throws Error
/// with the first number that cannot be meant, and where it stands.
GatheredShapes gather(const Description& description);

/// The caller's name of a primitive.
PrimitiveId name_of(const OccluderNames& names, ShapeRef ref);

}  // namespace penumbra
