// SPDX-License-Identifier: MIT
#include "penumbra/shadow/offset.h"

#include <algorithm>
#include <type_traits>

#include "penumbra/geometry/separation.h"
#include "penumbra/shadow/light_box.h"
#include "penumbra/shadow/record_hull.h"
#include "penumbra/shadow/sight.h"

namespace penumbra {
namespace {

struct Segment {
  Vec3d p, c;
  Vec3d support(Vec3d n) const { return dot(c - p, n) > 0 ? c : p; }
  Vec3d nearest(Vec3d x) const {
    const Vec3d along = c - p;
    const double way = dot(x - p, along), square = length_squared(along);
    if (!(way > 0)) return p;
    return way < square ? p + along * (way / square) : c;
  }
};

// Axes to look along first, from the hull to the segment. For cones from the nearest point of their
// axis: between thin ones there is none better.
Vec3d hint(const PointHull& hull, const Segment& core) {
  return core.nearest(hull.center) - hull.center;
}
Vec3d hint(const DiskHull& hull, const Segment& core) {
  return core.nearest(hull.center) - hull.center;
}
Vec3d hint(const FlatHull& hull, const Segment& core) {
  const Vec3d middle = (hull.a + hull.b + hull.c) * (1.0 / 3);
  return core.nearest(middle) - middle;
}
Vec3d hint(const ConeHull& hull, const Segment& core) {
  const Segment axis{hull.base, hull.apex};
  const Vec3d along = core.c - core.p, to = core.p - axis.p;
  const double square = length_squared(along), turn = dot(along, hull.axis);
  // Nearest points of the two lines, the core's clamped to it.
  const double below = square - turn * turn, above = turn * dot(to, hull.axis) - dot(along, to);
  const double s = below > 0 ? std::clamp(above / below, 0.0, 1.0) : 0;
  const Vec3d on_axis = axis.nearest(core.p + along * s);
  return core.nearest(on_axis) - on_axis;
}

/// The margins of this file are above 2^-21 of every coordinate in play: far above what double
/// loses.
template <typename Hull>
bool misses(const Hull& hull, const LightHull& light, Vec3f p, double t, double margin) {
  const Segment core{Vec3d(p), light.center(p)};
  const Vec3d away = hint(hull, core);
  if (!light.is_ball()) return surely_apart(ThickSegment(light, p, t), hull, away, margin);
  margin += t * light.size();
  if constexpr (std::is_same_v<Hull, PointHull>) return length(away) > margin;
  return surely_apart(core, hull, away, margin);
}

/// Whether the thick segment passes a ring's plane within its hole. The light's extent along the
/// plane is taken as that of a ball.
bool passes_hole(const Record& ring, const LightHull& light, Vec3f p, double t, double margin) {
  const DiskHull disk(ring);
  const Vec3d n = disk.normal, from = Vec3d(p) - disk.center, way = light.center(p) - Vec3d(p);
  const double z = dot(from, n), dz = dot(way, n);
  // Where the segment is so near to the plane that its thickness may touch it.
  const double lowest = -margin - t * dot(light.spread(n), n),
               highest = margin - t * dot(light.spread(-n), n);
  double first = 0, last = 1;
  if (dz != 0) {
    const double one = (lowest - z) / dz, other = (highest - z) / dz;
    first = std::max(first, std::min(one, other)), last = std::min(last, std::max(one, other));
  }
  const auto radius_at = [&](double s) {
    const Vec3d x = from + way * s;
    return length(x - n * dot(x, n));
  };
  const double hole = ring.number[7] - t * light.size() - margin;
  return radius_at(first) < hole && radius_at(last) < hole;
}

/// The offset itself.
bool segment_misses(const Record& record, const LightHull& light, Vec3f p, double t) {
  double margin = hit_bound(record, p) + t * light.doubt(p);
  if (record.kind == ShapeKind::sphere) margin += record.number[3];
  if (with_hull(record, [&](const auto& hull) { return misses(hull, light, p, t, margin); }))
    return true;
  return record.kind == ShapeKind::ring && record.number[7] > 0 &&
         passes_hole(record, light, p, t, margin);
}

}  // namespace

bool surely_misses_offset(const Record& record, const LightHull& light, Vec3f p, double t) {
  if (!is_finite(p) || !is_in_range(record, light, p)) return false;
  // What is likely first: most triangles in question are neighbours of the one that p lies on.
  if (record.kind == ShapeKind::triangle)
    return surely_behind_horizon(record, light, p) || segment_misses(record, light, p, t);
  return segment_misses(record, light, p, t) || surely_behind_horizon(record, light, p);
}

Box offset_bounds(const Box& occluder, const LightHull& light, double t, const Box& receivers) {
  const ExtentBox& spread = light.spread_box();
  const double pad = greatest_hit_bound(occluder, receivers) + greatest_doubt(light, receivers);
  const Vec3d all(pad, pad, pad);
  // The light is reflected: q = x + t (l - c).
  return outward(Vec3d(occluder.lo) - spread.hi * t - all,
                 Vec3d(occluder.hi) - spread.lo * t + all);
}

}  // namespace penumbra
