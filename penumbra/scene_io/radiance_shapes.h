// SPDX-License-Identifier: MIT
// Radiance's surfaces as our shapes.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "penumbra/geometry/shape.h"
#include "penumbra/geometry/transform.h"
#include "penumbra/scene_io/radiance_file.h"

namespace penumbra {

/// Which side of a surface is its front, beyond what its type says: Radiance turns spheres into
/// bubbles, and polygons around, for `xform -I` and for negative radii.
enum class RadianceSide { as_it_is, inverted };

/// A surface, checked: one of the shapes, or a polygon. Nothing: it has no size.
struct RadianceShape {
  enum class Kind { none, sphere, cone, ring, polygon };
  Kind kind = Kind::none;
  // As numbers of a file, in double: what is placed is rounded once.
  Vec3d a, b;             ///< centre; a cone's base and apex; a ring's centre and normal
  double r0 = 0, r1 = 0;  ///< radius; a cone's at its ends; a ring's inner and outer one
  std::vector<Vec3d> corners;
  bool faces_inward = false;  ///< bubbles, tubes, cups; polygons and rings that are turned about
};

/// Throws Error with the line of a surface whose numbers make no sense.
RadianceShape radiance_shape(const RadianceFile& file, const RadiancePrimitive& surface,
                             RadianceSide side);

/// Placed by a map that keeps shapes: rotation, uniform scale, mirror. What was the front stays it.
RadianceShape placed(RadianceShape shape, const Transform& map);

/// The mean length of a way through the solid that the shape bounds, by its radius (4/3 of it in a
/// ball, 2 in a long cylinder); nothing for flat ones.
std::optional<double> mean_chord(const RadianceShape& shape);

/// Adds it to `shapes`; polygons to the mesh `polygons`, whose triangles have surfaces of their
/// own.
void add_shape(ShapeSet& shapes, Mesh& polygons, const RadianceShape& shape, std::uint32_t surface);

/// Cones and rings as triangles, their fronts counter-clockwise, added to `mesh`; solid ones with
/// their ends, so that they are closed.
void add_faceted(Mesh& mesh, const RadianceShape& shape, std::uint32_t surface);

/// Welds a mesh of polygons and gives it one surface where all are the same; joins the shapes
/// unless it is empty.
void finish_polygons(ShapeSet& shapes, Mesh polygons);

}  // namespace penumbra
