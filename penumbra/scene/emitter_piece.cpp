// SPDX-License-Identifier: MIT
#include "penumbra/scene/emitter_piece.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "penumbra/geometry/centroid.h"
#include "penumbra/geometry/planar_hull.h"
#include "penumbra/geometry/reduced_hull.h"
#include "penumbra/scene/check_light.h"

namespace penumbra {
namespace {

constexpr std::size_t most_polygon_corners = 16;
/// A regular polygon of so many corners is a disk.
constexpr std::size_t least_disk_corners = 16;
constexpr std::size_t most_points = 256;

/// Of its length: how thick a hull may be and count as flat.
constexpr double flat_tolerance = 1e-3;
/// Of a quadrangle's longer diagonal: how far its corner may lie from that of a parallelogram.
constexpr double corner_tolerance = 1e-4;

/// The hull's longest extents, one across the other.
struct Extents {
  Vec3d a, b;    ///< ends of the longest
  Vec3d across;  ///< unit
  Vec3d normal;  ///< unit, of the plane of both; 0 where the points are in a row
  double long_ = 0, wide = 0, thick = 0;
};

Vec3d farthest_from(std::span<const Vec3f> points, Vec3d from) {
  Vec3d best = from;
  for (const Vec3f p : points)
    if (length_squared(Vec3d(p) - from) > length_squared(best - from)) best = Vec3d(p);
  return best;
}

Extents extents_of(std::span<const Vec3f> points) {
  Extents e;
  e.a = farthest_from(points, farthest_from(points, Vec3d(points[0])));
  e.b = farthest_from(points, e.a);
  const Vec3d along = normalize(e.b - e.a);
  e.long_ = length(e.b - e.a);
  double highest = 0;
  for (const Vec3f p : points) {
    const Vec3d off = (Vec3d(p) - e.a) - along * dot(along, Vec3d(p) - e.a);
    if (length(off) > highest) highest = length(off), e.across = normalize(off);
  }
  e.normal = normalize(cross(along, e.across));
  double low = 0, high = 0, left = 0, right = 0;
  for (const Vec3f p : points) {
    const double side = dot(e.across, Vec3d(p) - e.a), up = dot(e.normal, Vec3d(p) - e.a);
    left = std::min(left, side), right = std::max(right, side);
    low = std::min(low, up), high = std::max(high, up);
  }
  e.wide = right - left, e.thick = high - low;
  return e;
}

/// The hull of points of a plane, in order around it, counter-clockwise about n.
struct FlatHull {
  std::vector<Vec3f> corners;
  double area = 0;
};

FlatHull flat_hull(std::span<const Vec3f> points, Vec3d n, double size) {
  const Frame<double> frame = frame_around(n);
  const Vec3d origin(points[0]);
  std::vector<PlanePoint> flat;
  std::map<std::pair<double, double>, Vec3f> point_at;
  for (const Vec3f p : points) {
    const Vec3d q = Vec3d(p) - origin;
    flat.push_back({dot(q, frame.u), dot(q, frame.v)});
    point_at.emplace(std::pair(flat.back().x, flat.back().y), p);
  }
  std::vector<PlanePoint> ring = planar_hull(std::move(flat));
  FlatHull hull{{}, area(ring)};
  const std::size_t corners = ring.size();
  ring = fewer_corners(std::move(ring), corners, 1e-5 * size);
  for (const PlanePoint p : ring) {
    const auto known = point_at.find({p.x, p.y});
    hull.corners.push_back(known != point_at.end() ? known->second
                                                   : Vec3f(origin + frame.u * p.x + frame.v * p.y));
  }
  return hull;
}

std::optional<ParallelogramLight> parallelogram(std::span<const Vec3f> corners, double size) {
  if (corners.size() != 4) return {};
  const Vec3d a(corners[0]), b(corners[1]), c(corners[2]), d(corners[3]);
  if (!(length(a + c - b - d) <= corner_tolerance * size)) return {};
  return ParallelogramLight{Vec3f((b + d) * 0.5), Vec3f((b - a) * 0.5), Vec3f((d - a) * 0.5)};
}

std::optional<DiskLight> disk(const FlatHull& hull, Vec3d n) {
  if (hull.corners.size() < least_disk_corners) return {};
  const Vec3f center = area_centroid(hull.corners);
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const Vec3f corner : hull.corners) {
    const double distance = length(Vec3d(corner) - Vec3d(center));
    least = std::min(least, distance), most = std::max(most, distance);
  }
  constexpr double pi = std::numbers::pi;
  // The area of the regular polygon of least_disk_corners tells an even spread.
  if (most - least > 2e-3 * most || hull.area < 0.97 * pi * most * most) return {};
  return DiskLight{center, Vec3f(n), static_cast<float>(std::sqrt(hull.area / pi))};
}

LightShape flat_shape(std::span<const Vec3f> points, Vec3d n, double size,
                      std::size_t most_corners) {
  FlatHull hull = flat_hull(points, n, size);
  if (const auto shape = parallelogram(hull.corners, size)) return *shape;
  if (const auto shape = disk(hull, n)) return *shape;
  const std::size_t most = std::min(most_corners, most_polygon_corners);
  if (hull.corners.size() > most) {
    const Frame<double> frame = frame_around(n);
    const Vec3d origin(hull.corners[0]);
    std::vector<PlanePoint> ring;
    for (const Vec3f p : hull.corners)
      ring.push_back({dot(Vec3d(p) - origin, frame.u), dot(Vec3d(p) - origin, frame.v)});
    ring = fewer_corners(std::move(ring), most, 0);
    hull.corners.clear();
    for (const PlanePoint p : ring)
      hull.corners.push_back(Vec3f(origin + frame.u * p.x + frame.v * p.y));
  }
  return PolygonLight{area_centroid(hull.corners), std::move(hull.corners)};
}

bool is_flat_shape(const LightShape& shape) {
  return std::holds_alternative<ParallelogramLight>(shape) ||
         std::holds_alternative<DiskLight>(shape) || std::holds_alternative<PolygonLight>(shape);
}

/// Of what has no shape that a light could have.
LightShape thin_shape(const Extents& e) {
  constexpr double row = 4;  // longer ones are lines
  const Vec3f center((e.a + e.b) * 0.5);
  if (e.long_ > row * e.wide) return LineLight{center, Vec3f((e.b - e.a) * 0.5)};
  return BallLight{center, static_cast<float>(0.25 * (e.long_ + e.wide))};
}

/// Corners moved along n into the plane through the piece's centre.
std::vector<Vec3f> flattened(const EmitterPiece& piece, Vec3d n) {
  std::vector<Vec3f> points;
  for (const Vec3f p : piece.points)
    points.emplace_back(Vec3f(Vec3d(p) - n * dot(n, Vec3d(p) - piece.center)));
  return points;
}

/// Of what is flat, or as good as flat for those it shines on.
Light flat_light(const EmitterPiece& piece, const Extents& e, std::size_t most_corners) {
  constexpr double along_axis = 0.7;
  EmitterPiece flat = piece;
  Vec3d n = e.normal;
  if (piece.shines == Shines::front) {
    if (dot(n, piece.axis) < 0) n = -n;
    if (dot(n, piece.axis) < along_axis) return with_power(thin_shape(e), piece);
    flat.axis = n;
  }
  return with_power(flat_shape(piece.points, n, e.long_, most_corners), flat);
}

Light solid_light(const EmitterPiece& piece, const Extents& e, std::size_t most_corners) {
  // What was put together is no certain form: if it is as thick as this, a ball costs least.
  constexpr double ball = 0.5;
  if (piece.is_joined && piece.shines == Shines::around && e.thick > ball * e.long_)
    return with_power(
        BallLight{Vec3f((e.a + e.b) * 0.5), static_cast<float>(0.25 * (e.long_ + e.wide))}, piece);
  std::optional<MeshLight> hull = reduced_hull(piece.points, most_corners);
  const Light light = with_power(hull ? LightShape(*std::move(hull)) : thin_shape(e), piece);
  if (piece.axis == Vec3d{}) return light;
  // Leaves that face one way shine like a plane, wherever they hang.
  EmitterPiece leaf = piece;
  leaf.points = flattened(piece, piece.axis);
  const Extents of_leaf = extents_of(leaf.points);
  const Light plane = flat_light(leaf, of_leaf, most_corners);
  const bool is_better =
      misdirected(piece.field, field_of(plane)) < 0.7 * misdirected(piece.field, field_of(light));
  return is_better && !problem_of(plane.shape) ? plane : light;
}

}  // namespace

EmitterPiece piece_of(std::span<const GlowingTriangle> triangles, Sides sides, Vec3d power) {
  EmitterPiece piece;
  Vec3d normal, center;
  double area = 0;
  const Vec3d origin(triangles[0][0]);
  for (const GlowingTriangle& t : triangles) {
    const double of_it = area_of(t);
    piece.points.insert(piece.points.end(), t.begin(), t.end());
    normal += normal_of(t) * 0.5;
    area += of_it;
    for (const Vec3f p : t) center += (Vec3d(p) - origin) * (of_it / 3);
  }
  piece.center = origin + center / area;
  piece.points = extreme_points(piece.points, most_points);
  piece.power = power;
  piece.field = field_of(triangles, sides, power);
  if (sides == Sides::both) piece.shines = Shines::both;
  // Of a closed surface 0, of a hemisphere half its area, of a half cylinder 2 / pi of it.
  constexpr double least_share = 0.45;
  if (sides == Sides::front && length(normal) > least_share * area)
    piece.shines = Shines::front, piece.axis = normalize(normal);
  return piece;
}

Light with_power(LightShape shape, const EmitterPiece& piece) {
  // Intensities: of flat shapes along their normal, of others the mean over all directions. Half of
  // the directions get all of it where it shines to the front.
  const bool is_front = piece.shines == Shines::front;
  double part = is_flat_shape(shape) ? 0.5 : 0.25;
  if (is_front) part *= 2;
  Light light{std::move(shape), Color(piece.power * part), Falloff::inverse_square, {}};
  if (is_front) light.beam = Beam{Vec3f(piece.axis), 0, 0};
  return light;
}

std::optional<Light> light_of(const EmitterPiece& piece, std::size_t most_corners) {
  if (piece.points.empty() || !is_finite(piece.power)) return {};
  const Extents e = extents_of(piece.points);
  Light light = piece.ball                            ? with_power(*piece.ball, piece)
                : e.thick <= flat_tolerance * e.long_ ? flat_light(piece, e, most_corners)
                                                      : solid_light(piece, e, most_corners);
  if (problem_of(light.shape))
    light = with_power(LineLight{Vec3f((e.a + e.b) * 0.5), Vec3f((e.b - e.a) * 0.5)}, piece);
  if (problem_of(light.shape) || !is_finite(light.intensity)) return {};
  return light;
}

}  // namespace penumbra
