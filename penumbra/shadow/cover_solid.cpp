// SPDX-License-Identifier: MIT
#include "penumbra/shadow/cover_solid.h"

#include "penumbra/geometry/separation.h"
#include "penumbra/shadow/chord.h"
#include "penumbra/shadow/disk.h"

namespace penumbra {
namespace {

struct Ball {
  Vec3d center;
  double radius;

  /// How deep inside x lies: a lower bound of the distance to the surface; negative outside.
  double depth(Vec3d x) const { return radius - length(x - center); }
  Vec3d support(Vec3d n) const { return center + normalize(n) * radius; }
  /// Where depth(p + s way) >= margin + s growth.
  Chord chord(Vec3d p, Vec3d way, double growth, double margin) const {
    return chord_of_cone(p - center, way, radius - margin, -growth);
  }
};

/// The solid of a cone record.
struct ConeSolid {
  Vec3d base, axis;
  double height, base_radius, apex_radius;
  double slope, steepness;  // steepness: sqrt(1 + slope²), from distances along the radius to such
                            // from the side

  double radius_at(double z) const { return base_radius + slope * z; }
  double depth(Vec3d x) const {
    const double z = dot(x - base, axis), radial = length(x - base - axis * z);
    return std::min({z, height - z, (radius_at(z) - radial) / steepness});
  }
  Vec3d support(Vec3d n) const {
    const Vec3d across = farthest_of_unit_disk(axis, n);
    const Vec3d low = base + across * base_radius;
    const Vec3d high = base + axis * height + across * apex_radius;
    return dot(high - low, n) > 0 ? high : low;
  }
  Chord side_chord(Vec3d p, Vec3d way, double growth, double margin) const {
    const Vec3d from = p - base;
    const double z = dot(from, axis), rise = dot(way, axis);
    return chord_of_cone(from - axis * z, way - axis * rise, radius_at(z) - margin * steepness,
                         slope * rise - growth * steepness);
  }
  Chord slab_chord(Vec3d p, Vec3d way, double growth, double margin) const {
    const double z = dot(p - base, axis), rise = dot(way, axis);
    return common(chord_below(margin - z, growth - rise),
                  chord_below(z - height + margin, rise + growth));
  }
  Chord chord(Vec3d p, Vec3d way, double growth, double margin) const {
    return common(slab_chord(p, way, growth, margin), side_chord(p, way, growth, margin));
  }
};

ConeSolid solid_of(const Record& record) {
  ConeSolid cone{Vec3d(record.vector(0)),
                 normalize(Vec3d(record.vector(3))),
                 record.number[6],
                 record.number[7],
                 record.number[8],
                 0,
                 1};
  cone.slope = (cone.apex_radius - cone.base_radius) / cone.height;
  cone.steepness = std::sqrt(1 + cone.slope * cone.slope);
  return cone;
}

/// Whether a ball of radius s growth around p + s way lies deeper than the margin inside the solid,
/// for an s in [0, 1]. The chord only proposes the s.
template <typename Solid>
bool holds_section(const Solid& solid, Vec3d p, Vec3d way, double growth, double margin) {
  const Chord chord = common(solid.chord(p, way, growth, margin), {0, 1});
  if (chord.is_empty()) return false;
  const double s = chord.from + (chord.to - chord.from) / 2;
  return solid.depth(p + way * s) - s * growth > margin;
}

/// Whether the cross-section of a ball that holds the light does so, for one s.
template <typename Solid>
bool hides_ball_around_light(const Solid& solid, const Sight& sight) {
  return holds_section(solid, sight.shaft.p, sight.to_center(),
                       sight.shaft.light.size() + sight.doubt, sight.margin);
}

/// Whether every ray passes deeply through the solid, each of the light's corners by itself: what
/// the solid hides from p is convex. Exact but for the margin and the outlines of balls.
template <typename Solid>
bool hides_outline(const Solid& solid, const Sight& sight) {
  return holds_for_outline(sight.shaft, [&](Vec3d way) {
    return holds_section(solid, sight.shaft.p, way, sight.doubt, sight.margin);
  });
}

/// For balls the one cross-section is exact.
bool hides(const Ball& ball, const Sight& sight) {
  return hides_ball_around_light(ball, sight) ||
         (!sight.shaft.light.is_ball() && hides_outline(ball, sight));
}

/// Cones need the outline of ball lights near their caps, where no ball fits but all rays pass;
/// where it is their side that a ball doesn't fit into, the outline wouldn't either.
bool hides(const ConeSolid& cone, const Sight& sight) {
  const Vec3d p = sight.shaft.p, way = sight.to_center();
  if (!holds_section(cone, p, way, sight.doubt, sight.margin)) return false;
  if (hides_ball_around_light(cone, sight)) return true;
  const double growth = sight.shaft.light.size() + sight.doubt;
  if (sight.shaft.light.is_ball() &&
      common(cone.side_chord(p, way, growth, sight.margin), {0, 1}).is_empty())
    return false;
  return hides_outline(cone, sight);
}

template <typename Solid>
bool light_is_outside(const Solid& solid, Vec3d inner, const Sight& sight) {
  return surely_apart(LightSet{sight.shaft.light, sight.shaft.c}, solid, sight.shaft.c - inner,
                      sight.margin + sight.doubt);
}

/// A ray crosses the solid's surface twice, or once for p inside. An apex counts as a cap: what
/// passes there is not sure to be a hit.
bool side_is_crossed(const ConeSolid& cone, const Sight& sight) {
  const auto misses_cap = [&](double z, double radius) {
    return shaft_misses({cone.base + cone.axis * z, cone.axis, radius}, sight);
  };
  const bool misses_base = misses_cap(0, cone.base_radius);
  const bool is_outside = cone.depth(sight.shaft.p) < -sight.margin;
  if (misses_base && is_outside) return true;
  if (!misses_base && !is_outside) return false;
  return misses_cap(cone.height, cone.apex_radius);
}

}  // namespace

bool ball_hides(Vec3d center, double radius, const Sight& sight) {
  return hides(Ball{center, radius}, sight);
}

bool sphere_covers(const Record& record, const Sight& sight) {
  const Ball ball{Vec3d(record.vector(0)), record.number[3]};
  return hides(ball, sight) && light_is_outside(ball, ball.center, sight);
}

bool cone_covers(const Record& record, const Sight& sight) {
  const ConeSolid cone = solid_of(record);
  if (!(std::abs(cone.slope) <= 4) || !hides(cone, sight)) return false;
  if (!light_is_outside(cone, cone.base + cone.axis * (cone.height / 2), sight)) return false;
  return record.is_capped || side_is_crossed(cone, sight);
}

}  // namespace penumbra
