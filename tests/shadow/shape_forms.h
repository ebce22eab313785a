// SPDX-License-Identifier: MIT
// The ten forms of shape that a record can have, at random: the one maker of occluders for all
// tests of shadows.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "penumbra/kernel/record.h"
#include "tests/kernel/nasty_shapes.h"

namespace penumbra {

struct ShapeForm {
  const char* name;
  ShapeKind kind;
  void (*adjust)(ShapeSet&, nasty::Random&);  ///< makes a random shape of this kind one of the form
};

namespace forms {

/// Radii that differ, the base's up to 64 times the radius it had.
template <Caps caps>
void cone(ShapeSet& s, nasty::Random& random) {
  Cone& c = s.cones[0];
  c.base_radius *= std::pow(4.0f, random.uniform(0, 3)), c.caps = caps;
  if (random.one_in(2)) std::swap(c.base_radius, c.apex_radius);
}

template <Caps caps>
void cylinder(ShapeSet& s, nasty::Random&) {
  s.cones[0].apex_radius = s.cones[0].base_radius, s.cones[0].caps = caps;
}

inline void full_cone(ShapeSet& s, nasty::Random& random) {
  Cone& c = s.cones[0];
  if (random.one_in(2)) std::swap(c.base, c.apex);
  c.apex_radius = 0;
  if (random.one_in(4)) std::swap(c.base_radius, c.apex_radius);
}

inline void ring(ShapeSet& s, nasty::Random& random) {
  s.rings[0].inner_radius = s.rings[0].radius * random.uniform(0.01f, 0.9f);
}

/// No sliver.
inline void triangle(ShapeSet& s, nasty::Random& random) {
  auto& corner = s.meshes[0].positions;
  const Vec3d along(corner[1] - corner[0]), other(corner[2] - corner[0]);
  const double width = length(cross(along, other)) / std::max(length(along), length(other));
  if (!(width > 0.01 * length(along)))
    corner[2] = corner[0] + Vec3f(cross(along, random.direction() + Vec3d{0.1, 0.2, 0.3}));
}

inline void sliver(ShapeSet& s, nasty::Random& random) {
  auto& corner = s.meshes[0].positions;
  const Vec3f along = corner[1] - corner[0];
  corner[2] = corner[0] + along * random.uniform(-1, 1) +
              random.in_cube() * (max_abs(along) * random.power(-5, -1));
}

}  // namespace forms

inline constexpr std::array shape_forms = {
    ShapeForm{"sphere", ShapeKind::sphere, [](ShapeSet&, nasty::Random&) {}},
    ShapeForm{"capped_cone", ShapeKind::cone, forms::cone<Caps::capped>},
    ShapeForm{"open_cone", ShapeKind::cone, forms::cone<Caps::open>},
    ShapeForm{"capped_cylinder", ShapeKind::cone, forms::cylinder<Caps::capped>},
    ShapeForm{"open_cylinder", ShapeKind::cone, forms::cylinder<Caps::open>},
    ShapeForm{"full_cone", ShapeKind::cone, forms::full_cone},
    ShapeForm{"disk", ShapeKind::ring,
              [](ShapeSet& s, nasty::Random&) { s.rings[0].inner_radius = 0; }},
    ShapeForm{"ring", ShapeKind::ring, forms::ring},
    ShapeForm{"triangle", ShapeKind::triangle, forms::triangle},
    ShapeForm{"sliver", ShapeKind::triangle, forms::sliver}};

/// One primitive of this form, no triangle of no area.
inline ShapeSet random_shape(const ShapeForm& form, const nasty::Place& place,
                             nasty::Random& random) {
  for (;;) {
    ShapeSet shapes = nasty::random_shapes(form.kind, 1, place, random);
    if (primitive_count(shapes) != 1) continue;
    form.adjust(shapes, random);
    for (Mesh& mesh : shapes.meshes) drop_degenerate_triangles(mesh);
    if (primitive_count(shapes) == 1) return shapes;
  }
}

inline ShapeRef only_primitive(const ShapeSet& shapes) { return all_primitives(shapes).front(); }

inline Record only_record(const ShapeSet& shapes) {
  return make_record(shapes, only_primitive(shapes), 0);
}

}  // namespace penumbra
