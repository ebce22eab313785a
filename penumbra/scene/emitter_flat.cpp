// SPDX-License-Identifier: MIT
#include "penumbra/scene/emitter_flat.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "penumbra/geometry/flat_pieces.h"
#include "penumbra/geometry/planar_hull.h"

namespace penumbra {
namespace {

/// Of the surface's size.
constexpr double thickness = 5e-4;

/// The plane of a surface, and its triangles in it.
struct Plane {
  Vec3d origin;
  Frame<double> frame;
  std::vector<PlaneTriangle> front, back;  ///< those that turn left, and right, about the normal
  std::map<std::pair<double, double>, Vec3f> point_at;
};

/// Nothing where the surface has none.
std::optional<Vec3d> normal_of_plane(const GlowingSurface& surface) {
  const auto largest = std::max_element(
      surface.triangles.begin(), surface.triangles.end(),
      [](const GlowingTriangle& a, const GlowingTriangle& b) { return area_of(a) < area_of(b); });
  const Vec3d first = normal_of(*largest);
  Vec3d sum;
  Box box;
  for (const GlowingTriangle& t : surface.triangles) {
    const Vec3d normal = normal_of(t);
    sum += dot(normal, first) < 0 ? -normal : normal;
    for (const Vec3f p : t) box.add(p);
  }
  const Vec3d n = normalize(sum), origin(surface.triangles[0][0]);
  double low = 0, high = 0;
  for (const GlowingTriangle& t : surface.triangles)
    for (const Vec3f p : t) {
      const double height = dot(n, Vec3d(p) - origin);
      low = std::min(low, height), high = std::max(high, height);
    }
  if (!(high - low <= thickness * length(Vec3d(box.hi) - Vec3d(box.lo)))) return {};
  return n;
}

Plane plane_of(const GlowingSurface& surface, Vec3d n) {
  Plane plane{Vec3d(surface.triangles[0][0]), frame_around(n), {}, {}, {}};
  for (const GlowingTriangle& t : surface.triangles) {
    // The sides of slabs are no part of it.
    const Vec3d normal = normalize(normal_of(t));
    if (std::abs(dot(normal, n)) < 0.1) continue;
    PlaneTriangle flat;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d q = Vec3d(t[i]) - plane.origin;
      flat[i] = {dot(q, plane.frame.u), dot(q, plane.frame.v)};
      plane.point_at.emplace(std::pair(flat[i].x, flat[i].y), t[i]);
    }
    (dot(normal, n) > 0 ? plane.front : plane.back).push_back(flat);
  }
  return plane;
}

/// In space again; what shines which way is left to the caller.
EmitterPiece piece_of(const FlatPiece& flat, const Plane& plane) {
  EmitterPiece piece;
  Vec3d center;
  for (const PlanePoint p : flat.ring) {
    const auto known = plane.point_at.find({p.x, p.y});
    piece.points.push_back(known != plane.point_at.end()
                               ? known->second
                               : Vec3f(plane.origin + plane.frame.u * p.x + plane.frame.v * p.y));
    center += Vec3d(piece.points.back());
  }
  piece.center = center / static_cast<double>(flat.ring.size());
  return piece;
}

/// The same polygons, to 10⁻⁴ of their area.
bool are_alike(const std::vector<FlatPiece>& a, const std::vector<FlatPiece>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::vector<PlanePoint> both = a[i].ring;
    both.insert(both.end(), b[i].ring.begin(), b[i].ring.end());
    const double area_of_both = area(planar_hull(both));
    const double least = std::min({a[i].area, b[i].area, area(a[i].ring), area(b[i].ring)});
    const double most = std::max({a[i].area, b[i].area, area_of_both});
    // Their areas, and hulls that don't fill what is empty in the other.
    if (std::abs(a[i].area - b[i].area) > 1e-4 * most) return false;
    if (area_of_both - std::min(area(a[i].ring), area(b[i].ring)) > 1e-4 * most) return false;
    if (!(least > 0)) return false;
  }
  return true;
}

void add(const std::vector<FlatPiece>& flats, const Plane& plane, Shines shines, Vec3d axis,
         std::vector<EmitterPiece>& pieces) {
  for (const FlatPiece& flat : flats) {
    EmitterPiece piece = piece_of(flat, plane);
    piece.shines = shines;
    piece.axis = axis;
    const double sides = shines == Shines::both ? 2 : 1;
    piece.power = Vec3d(sides * flat.area, 0, 0);  // for now
    pieces.push_back(std::move(piece));
  }
}

/// Power by each piece's part of all: what tilted triangles and the sides of slabs have more than
/// what is seen of them in the plane is spread over all.
void give_power(std::vector<EmitterPiece>& pieces, const GlowingSurface& surface) {
  const double sides = surface.is_two_sided && !surface.is_closed ? 2 : 1;
  double sum = 0;
  for (const EmitterPiece& piece : pieces) sum += piece.power.x;
  const Vec3d power = Vec3d(surface.radiance) * (sides * area_of(surface.triangles));
  for (EmitterPiece& piece : pieces) {
    piece.power = power * (piece.power.x / sum);
    const Vec3d n = piece.axis;
    std::vector<GlowingTriangle> fan;
    for (std::size_t i = 2; i < piece.points.size(); ++i)
      fan.push_back({piece.points[0], piece.points[i - 1], piece.points[i]});
    if (piece.shines == Shines::front)
      for (GlowingTriangle& t : fan)
        if (dot(normal_of(t), n) < 0) std::swap(t[1], t[2]);
    piece.field =
        field_of(fan, piece.shines == Shines::front ? Sides::front : Sides::both, piece.power);
  }
}

}  // namespace

std::optional<std::vector<EmitterPiece>> flat_pieces_of(const GlowingSurface& surface,
                                                        std::size_t most) {
  const std::optional<Vec3d> n = normal_of_plane(surface);
  if (!n) return {};
  Plane plane = plane_of(surface, *n);
  std::vector<EmitterPiece> pieces;
  if (surface.is_two_sided && !surface.is_closed) {
    plane.front.insert(plane.front.end(), plane.back.begin(), plane.back.end());
    add(flat_pieces(plane.front, most), plane, Shines::both, *n, pieces);
  } else {
    const std::vector<FlatPiece> front = flat_pieces(plane.front, most);
    const std::vector<FlatPiece> back = flat_pieces(plane.back, most);
    if (!front.empty() && are_alike(front, back)) {
      add(front, plane, Shines::both, *n, pieces);
    } else {
      add(front, plane, Shines::front, *n, pieces);
      add(back, plane, Shines::front, -*n, pieces);
    }
  }
  if (pieces.empty()) return {};
  give_power(pieces, surface);
  return pieces;
}

}  // namespace penumbra
