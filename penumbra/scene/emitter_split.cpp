// SPDX-License-Identifier: MIT
#include "penumbra/scene/emitter_split.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "penumbra/geometry/centroid.h"
#include "penumbra/geometry/convex_hull.h"
#include "penumbra/geometry/reduced_hull.h"
#include "penumbra/scene/cut_triangles.h"
#include "penumbra/scene/emitter_flat.h"
#include "penumbra/scene/far_field.h"
#include "penumbra/scene/silhouette.h"

namespace penumbra {
namespace {

/// Of the silhouettes of its hull: how much a part may leave empty.
constexpr double empty_enough_to_cut = 0.05;
/// Of its light: how much a part's light may send elsewhere.
constexpr double wrong_enough_to_cut = 0.15;
/// Of the area: less is not cut off.
constexpr double least_share = 0.02;
/// Cuts are tried out on so many triangles, of corners moved to a lattice of so many points.
constexpr std::size_t most_tried = 2500;
constexpr double finest_lattice = 80;
constexpr std::size_t most_tried_corners = 48;

using Triangles = std::vector<GlowingTriangle>;

/// Of the light that triangles make.
struct Fault {
  double empty = 0;  ///< part of the hull's silhouettes
  double wrong = 0;  ///< part of the light
  double size() const { return empty / empty_enough_to_cut + wrong / wrong_enough_to_cut; }
};

struct Part {
  Triangles triangles;
  Triangles coarse;  ///< to judge it by: the same, or fewer
  Fault fault;
};

/// How a whole surface shines, and what its parts inherit.
struct Glow {
  Sides sides = Sides::both;
  Vec3d power_per_area;
};

/// The light that a part would be, roughly: its corners are few, and its intensity 1.
Fault fault_of(std::span<const GlowingTriangle> triangles, const Glow& glow) {
  EmitterPiece piece = piece_of(triangles, glow.sides, Vec3d(1, 1, 1));
  const double all = total(piece.field);
  const std::optional<MeshLight> hull =
      convex_hull(extreme_points(piece.points, most_tried_corners));
  if (!hull || !(all > 0)) return {};
  return {empty_part(triangles, *hull, piece.axis),
          misdirected(piece.field, field_of(with_power(*hull, piece))) / all};
}

/// With corners moved to the points of a lattice; what has no area there is left out
/// (J. Rossignac, P. Borrel, Multi-resolution 3D approximations for rendering, 1993).
Triangles on_lattice(const Triangles& triangles, Vec3d origin, double step) {
  const auto moved = [&](Vec3f p) {
    const Vec3d q = (Vec3d(p) - origin) / step;
    return Vec3f(origin + Vec3d(std::round(q.x), std::round(q.y), std::round(q.z)) * step);
  };
  Triangles few;
  for (const GlowingTriangle& t : triangles) {
    const GlowingTriangle rough{moved(t[0]), moved(t[1]), moved(t[2])};
    if (area_of(rough) > 0) few.push_back(rough);
  }
  const auto before = [](const GlowingTriangle& s, const GlowingTriangle& t) {
    return std::lexicographical_compare(
        s.begin(), s.end(), t.begin(), t.end(),
        [](Vec3f a, Vec3f b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); });
  };
  std::sort(few.begin(), few.end(), before);
  few.erase(std::unique(few.begin(), few.end()), few.end());
  return few;
}

/// The same, or not many more than `most_tried` triangles much like them.
Triangles coarse(const Triangles& triangles) {
  Box box;
  for (const GlowingTriangle& t : triangles)
    for (const Vec3f p : t) box.add(p);
  const double size = length(Vec3d(box.hi) - Vec3d(box.lo));
  Triangles few = triangles;
  for (double cells = finest_lattice; few.size() > most_tried && cells > 4; cells *= 0.7) {
    Triangles fewer = on_lattice(few, Vec3d(box.lo), size / cells);
    if (fewer.empty()) break;
    few = std::move(fewer);
  }
  return few;
}

Part part_of(Triangles triangles, Triangles coarse, const Glow& glow) {
  const Fault fault = coarse.empty() ? Fault{} : fault_of(coarse, glow);
  return {std::move(triangles), std::move(coarse), fault};
}

/// The middle of the surface and the directions in which it extends, by area.
struct Moments {
  Vec3d center;
  std::array<Vec3d, 3> axes;
};

/// Eigenvectors of a symmetric matrix, by Jacobi's rotations.
std::array<Vec3d, 3> eigenvectors(std::array<Vec3d, 3> m) {
  std::array<Vec3d, 3> v{Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)};
  for (int sweep = 0; sweep < 12; ++sweep)
    for (int p = 0; p < 2; ++p)
      for (int q = p + 1; q < 3; ++q) {
        const auto pi = static_cast<std::size_t>(p), qi = static_cast<std::size_t>(q);
        if (std::abs(m[pi][q]) == 0) continue;
        const double angle = 0.5 * std::atan2(2 * m[pi][q], m[qi][q] - m[pi][p]);
        const double c = std::cos(angle), s = std::sin(angle);
        const Vec3d row_p = m[pi] * c - m[qi] * s, row_q = m[pi] * s + m[qi] * c;
        m[pi] = row_p, m[qi] = row_q;
        for (Vec3d& row : m) {
          const double a = row[p] * c - row[q] * s, b = row[p] * s + row[q] * c;
          row[p] = a, row[q] = b;
        }
        const Vec3d vp = v[pi] * c - v[qi] * s, vq = v[pi] * s + v[qi] * c;
        v[pi] = vp, v[qi] = vq;
      }
  return v;
}

Moments moments_of(std::span<const GlowingTriangle> triangles) {
  const Vec3d origin(triangles[0][0]);
  const auto middle = [&](const GlowingTriangle& t) {
    return (Vec3d(t[0]) + Vec3d(t[1]) + Vec3d(t[2])) / 3.0 - origin;
  };
  Vec3d sum;
  double area = 0;
  for (const GlowingTriangle& t : triangles) sum += middle(t) * area_of(t), area += area_of(t);
  const Vec3d center = sum / area;
  std::array<Vec3d, 3> spread;
  for (const GlowingTriangle& t : triangles) {
    // The middles of the edges have a triangle's second moments.
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d d = (Vec3d(t[i]) + Vec3d(t[(i + 1) % 3])) * 0.5 - origin - center;
      const double weight = area_of(t) / (3 * area);
      spread[0] += d * (d.x * weight), spread[1] += d * (d.y * weight);
      spread[2] += d * (d.z * weight);
    }
  }
  return {origin + center, eigenvectors(spread)};
}

/// Across the main directions through the middle, and along the largest faces.
std::vector<HalfSpace> candidate_planes(std::span<const GlowingTriangle> triangles) {
  const Moments moments = moments_of(triangles);
  std::vector<HalfSpace> planes;
  for (const Vec3d axis : moments.axes) planes.push_back({axis, dot(axis, moments.center)});
  std::map<std::array<long, 4>, std::pair<double, HalfSpace>> faces;
  Box box;
  for (const GlowingTriangle& t : triangles)
    for (const Vec3f p : t) box.add(p);
  const double size = length(Vec3d(box.hi) - Vec3d(box.lo));
  for (const GlowingTriangle& t : triangles) {
    const Vec3d n = normalize(normal_of(t));
    const double offset = dot(n, Vec3d(t[0])), height = (offset - dot(n, moments.center)) / size;
    const auto key = [](double x) { return std::lround(x * 256); };
    auto& [area, plane] = faces[{key(n.x), key(n.y), key(n.z), key(height)}];
    area += area_of(t);
    plane = {n, offset};
  }
  std::vector<std::pair<double, HalfSpace>> sorted;
  for (const auto& [key, face] : faces) sorted.push_back(face);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  constexpr std::size_t most_faces = 8;
  for (std::size_t i = 0; i < std::min(most_faces, sorted.size()); ++i)
    planes.push_back(sorted[i].second);
  return planes;
}

/// Of both sides, by area; nothing where one side is as good as empty.
std::optional<Fault> fault_of(const Halves& halves, const Glow& glow) {
  const double below = area_of(halves.below), above = area_of(halves.above), all = below + above;
  if (!(std::min(below, above) > least_share * all)) return {};
  const Fault a = fault_of(halves.below, glow), b = fault_of(halves.above, glow);
  return Fault{(below * a.empty + above * b.empty) / all,
               (below * a.wrong + above * b.wrong) / all};
}

/// Nothing where every cut would leave one side as good as empty.
std::optional<HalfSpace> best_plane(std::span<const GlowingTriangle> triangles, const Glow& glow) {
  std::optional<HalfSpace> best;
  double least = std::numeric_limits<double>::infinity();
  for (const HalfSpace& plane : candidate_planes(triangles))
    if (const std::optional<Fault> fault = fault_of(cut(triangles, plane), glow))
      if (fault->size() < least * (1 - 1e-6)) best = plane, least = fault->size();
  return best;
}

/// Cuts the worst part in two as long as there is one and may be more.
std::vector<Part> cut_apart(Triangles triangles, const Glow& glow, std::size_t most) {
  std::vector<Part> parts;
  Triangles few = coarse(triangles);
  parts.push_back(part_of(std::move(triangles), std::move(few), glow));
  const auto weight = [](const Part& part) {
    return part.fault.size() > 1 ? part.fault.size() * area_of(part.triangles) : 0;
  };
  while (parts.size() < most) {
    const auto worst =
        std::max_element(parts.begin(), parts.end(),
                         [&](const Part& a, const Part& b) { return weight(a) < weight(b); });
    if (!(weight(*worst) > 0)) break;
    const std::optional<HalfSpace> plane = best_plane(worst->coarse, glow);
    Halves halves = plane ? cut(worst->triangles, *plane) : Halves{};
    if (!(area_of(halves.below) > 0) || !(area_of(halves.above) > 0)) {
      worst->fault = {};
      continue;
    }
    Halves few_halves = cut(worst->coarse, *plane);
    *worst = part_of(std::move(halves.below), std::move(few_halves.below), glow);
    parts.push_back(part_of(std::move(halves.above), std::move(few_halves.above), glow));
  }
  return parts;
}

std::vector<EmitterPiece> split_solid(Triangles triangles, const Glow& glow, std::size_t most) {
  const Vec3d power = glow.power_per_area * area_of(triangles);
  const std::vector<Part> parts = cut_apart(std::move(triangles), glow, most);
  double area = 0;  // cuts round corners
  for (const Part& part : parts) area += area_of(part.triangles);
  std::vector<EmitterPiece> pieces;
  for (const Part& part : parts)
    pieces.push_back(
        piece_of(part.triangles, glow.sides, power * (area_of(part.triangles) / area)));
  return pieces;
}

/// The ball that a closed surface is: all corners at one distance from its middle, and no face much
/// nearer.
std::optional<BallLight> ball_of(std::span<const GlowingTriangle> triangles) {
  constexpr double even = 1e-3, flattest = 0.95;
  Box box;
  for (const GlowingTriangle& t : triangles)
    for (const Vec3f p : t) box.add(p);
  const Vec3d center = (Vec3d(box.lo) + Vec3d(box.hi)) * 0.5;
  double nearest = std::numeric_limits<double>::infinity(), least = nearest, most = 0;
  for (const GlowingTriangle& t : triangles) {
    for (const Vec3f p : t) {
      const double distance = length(Vec3d(p) - center);
      least = std::min(least, distance), most = std::max(most, distance);
    }
    nearest = std::min(nearest, std::abs(dot(normalize(normal_of(t)), Vec3d(t[0]) - center)));
  }
  if (!(most - least <= even * most) || !(nearest >= flattest * most)) return {};
  return BallLight{Vec3f(center), static_cast<float>(most)};
}

double hull_surface(std::span<const GlowingTriangle> triangles, bool is_quick) {
  std::vector<Vec3f> points;
  Box box;
  for (const GlowingTriangle& t : triangles)
    for (const Vec3f p : t) points.push_back(p), box.add(p);
  const Vec3d d = Vec3d(box.hi) - Vec3d(box.lo);
  const double of_box = 2 * (d.x * d.y + d.y * d.z + d.z * d.x);
  if (is_quick) return of_box;
  const std::optional<MeshLight> hull = convex_hull(extreme_points(points, 256));
  return hull ? surface_area(*hull) : of_box;
}

Glow glow_of(const GlowingSurface& surface, bool is_quick) {
  Glow glow;
  glow.power_per_area = Vec3d(surface.radiance);
  if (surface.is_closed)
    glow.sides = surface.is_oriented ? Sides::front : Sides::outside;
  else if (!surface.is_two_sided)
    glow.sides = Sides::front;
  else
    glow.power_per_area =
        glow.power_per_area *
        std::min(2.0, hull_surface(surface.triangles, is_quick) / area_of(surface.triangles));
  return glow;
}

/// Closed surfaces that shine from both sides do so outwards, whichever way they turn.
Triangles outward(const GlowingSurface& surface) {
  Triangles triangles = surface.triangles;
  if (!surface.is_two_sided || !surface.is_oriented) return triangles;
  const Vec3d origin(triangles[0][0]);
  double volume = 0;
  for (const GlowingTriangle& t : triangles) volume += dot(normal_of(t), Vec3d(t[0]) - origin);
  if (volume < 0)
    for (GlowingTriangle& t : triangles) std::swap(t[1], t[2]);
  return triangles;
}

}  // namespace

std::vector<EmitterPiece> split(const GlowingSurface& surface, std::size_t most) {
  const bool is_quick = most <= 1;
  if (!is_quick)
    if (auto pieces = flat_pieces_of(surface, most)) return *std::move(pieces);
  Triangles triangles = outward(surface);
  const Glow glow = glow_of(surface, is_quick);
  if (surface.is_closed)
    if (const std::optional<BallLight> ball = ball_of(triangles)) {
      EmitterPiece piece =
          piece_of(triangles, glow.sides, glow.power_per_area * area_of(triangles));
      piece.ball = ball;
      return {std::move(piece)};
    }
  if (is_quick) return {piece_of(triangles, glow.sides, glow.power_per_area * area_of(triangles))};
  return split_solid(std::move(triangles), glow, most);
}

}  // namespace penumbra
