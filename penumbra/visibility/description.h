// SPDX-License-Identifier: MIT
// What a caller has added, before it is committed: views of his arrays.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "penumbra/geometry/shape.h"
#include "penumbra/geometry/transform.h"
#include "penumbra/visibility/rows.h"

namespace penumbra {

/// One geometry. Which rows mean what goes by its kind.
struct GeometryRows {
  ShapeKind kind = ShapeKind::triangle;
  VectorRows positions{};    ///< vertices, centres, bases
  VectorRows directions{};   ///< apexes of cones, normals of rings
  NumberRows radii{};        ///< of cones at the base
  NumberRows other_radii{};  ///< of cones at the apex; inner ones of rings, empty for none
  TriangleRows triangles{};
  Caps caps = Caps::open;
};

/// Numbers of what was taken out stay unused.
template <class T>
using Numbered = std::vector<std::optional<T>>;

struct Description {
  Numbered<GeometryRows> geometries;
  Numbered<Numbered<GeometryRows>> groups;
  Numbered<Instance> instances;
};

}  // namespace penumbra
