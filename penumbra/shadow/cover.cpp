// SPDX-License-Identifier: MIT
#include "penumbra/shadow/cover.h"

#include "penumbra/shadow/cover_flat.h"
#include "penumbra/shadow/cover_solid.h"

namespace penumbra {

bool surely_covers(const Record& record, const LightHull& light, Vec3f p) {
  if (!record.casts_shadow) return false;
  const Sight sight(light, p, intersector_margin(record, light, p));
  if (!(sight.margin + sight.doubt < std::numeric_limits<double>::infinity())) return false;
  switch (record.kind) {
    case ShapeKind::sphere: return sphere_covers(record, sight);
    case ShapeKind::cone: return cone_covers(record, sight);
    case ShapeKind::ring: return ring_covers(record, sight);
    case ShapeKind::triangle: break;
  }
  return triangle_covers(record, sight);
}

bool ball_covers(Vec3d center, double radius, const LightHull& light, Vec3f p, double margin) {
  return ball_hides(center, radius, Sight(light, p, margin));
}

}  // namespace penumbra
