// SPDX-License-Identifier: MIT
#include "penumbra/kernel/record.h"

namespace penumbra {
namespace {

Record sphere_record(const Sphere& s) {
  return {.number = {s.center.x, s.center.y, s.center.z, s.radius}, .kind = ShapeKind::sphere};
}

Record cone_record(const Cone& c) {
  const Vec3d along = Vec3d(c.apex) - Vec3d(c.base);
  const double height = length(along);
  const Vec3f axis(along / height);
  const double slope = (double(c.apex_radius) - double(c.base_radius)) / height;
  return {.number = {c.base.x, c.base.y, c.base.z, axis.x, axis.y, axis.z, float(height),
                     c.base_radius, c.apex_radius, float(slope)},
          .kind = ShapeKind::cone,
          .is_capped = c.caps == Caps::capped};
}

Record ring_record(const Ring& r) {
  return {.number = {r.center.x, r.center.y, r.center.z, r.normal.x, r.normal.y, r.normal.z,
                     r.radius, r.inner_radius},
          .kind = ShapeKind::ring};
}

Record triangle_record(const Mesh& mesh, std::uint32_t triangle) {
  Record record{.kind = ShapeKind::triangle};
  for (int corner = 0; corner < 3; ++corner)
    for (int axis = 0; axis < 3; ++axis)
      record.number[3 * corner + axis] = mesh.positions[mesh.triangles[triangle][corner]][axis];
  return record;
}

Record record_of(const ShapeSet& shapes, ShapeRef ref) {
  switch (ref.kind) {
    case ShapeKind::sphere: return sphere_record(shapes.spheres[ref.index]);
    case ShapeKind::cone: return cone_record(shapes.cones[ref.index]);
    case ShapeKind::ring: return ring_record(shapes.rings[ref.index]);
    case ShapeKind::triangle: break;
  }
  return triangle_record(shapes.meshes[ref.index], ref.triangle);
}

}  // namespace

Record make_record(const ShapeSet& shapes, ShapeRef ref, std::uint32_t id) {
  Record record = record_of(shapes, ref);
  record.id = id;
  return record;
}

Box bounds(const Record& record) {
  const Vec3f first = record.vector(0);
  switch (record.kind) {
    case ShapeKind::sphere: return bounds(Sphere{first, record.number[3], 0});
    case ShapeKind::cone: {
      const Vec3f apex(Vec3d(first) + Vec3d(record.vector(3)) * double(record.number[6]));
      return bounds(Cone{first, apex, record.number[7], record.number[8], Caps::open, 0});
    }
    case ShapeKind::ring:
      return bounds(Ring{first, record.vector(3), record.number[6], record.number[7], 0});
    case ShapeKind::triangle: break;
  }
  Box box;
  for (int corner = 0; corner < 3; ++corner) box.add(record.vector(3 * corner));
  return box;
}

}  // namespace penumbra
