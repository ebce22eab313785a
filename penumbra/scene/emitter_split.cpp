// SPDX-License-Identifier: MIT
#include "penumbra/scene/emitter_split.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "penumbra/geometry/centroid.h"
#include "penumbra/geometry/convex_hull.h"
#include "penumbra/geometry/reduced_hull.h"
#include "penumbra/scene/cut_triangles.h"
#include "penumbra/scene/emitter_flat.h"

namespace penumbra {
namespace {

/// Of its length: how deep, in the mean, a part may lie below its hull.
constexpr double deep_enough_to_cut = 0.01;
/// Of its light: how much a part's light may send elsewhere.
constexpr double wrong_enough_to_cut = 0.12;
/// Cuts are tried out on so many triangles.
constexpr std::size_t most_tried = 300;

using Triangles = std::vector<GlowingTriangle>;

struct Part {
  Triangles triangles;
  EmitterPiece piece;
  double fault = 0;  ///< of the light it makes; up to 1 is good enough
};

/// How a whole surface shines, and what its parts inherit.
struct Glow {
  Sides sides = Sides::both;
  Vec3d power_per_area;
};

double area_of(std::span<const GlowingTriangle> triangles) {
  double sum = 0;
  for (const GlowingTriangle& t : triangles) sum += area_of(t);
  return sum;
}

/// Of the surface, in the mean, below the hull of points; over its length.
double mean_depth(std::span<const GlowingTriangle> triangles, std::span<const Vec3f> points) {
  const std::optional<MeshLight> hull = convex_hull(points);
  if (!hull) return 0;
  const std::vector<HalfSpace> planes = face_planes(*hull);
  Box box;
  for (const Vec3f p : points) box.add(p);
  double sum = 0, area = 0;
  const std::size_t step = triangles.size() / most_tried + 1;
  for (std::size_t i = 0; i < triangles.size(); i += step) {
    const GlowingTriangle& t = triangles[i];
    const Vec3d middle = (Vec3d(t[0]) + Vec3d(t[1]) + Vec3d(t[2])) / 3.0;
    double depth = std::numeric_limits<double>::infinity();
    for (const HalfSpace& plane : planes)
      depth = std::min(depth, plane.offset - dot(plane.normal, middle));
    sum += std::max(0.0, depth) * area_of(t);
    area += area_of(t);
  }
  return sum / (area * length(Vec3d(box.hi) - Vec3d(box.lo)));
}

Part part_of(Triangles triangles, const Glow& glow) {
  Part part;
  part.piece = piece_of(triangles, glow.sides, glow.power_per_area * area_of(triangles));
  const std::optional<Light> light = light_of(part.piece);
  const double all = total(part.piece.field);
  const double wrong = light && all > 0 ? misdirected(part.piece.field, field_of(*light)) / all : 0;
  part.fault = std::max(mean_depth(triangles, part.piece.points) / deep_enough_to_cut,
                        wrong / wrong_enough_to_cut);
  part.triangles = std::move(triangles);
  return part;
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

/// Faults of both sides, by area; nothing where one side is empty.
std::optional<double> fault_of(const Halves& halves, const Glow& glow) {
  double sum = 0, area = 0;
  for (const Triangles& half : {halves.below, halves.above}) {
    const double of_it = area_of(half);
    if (!(of_it > 0)) return {};
    sum += of_it * part_of(half, glow).fault;
    area += of_it;
  }
  if (std::min(area_of(halves.below), area_of(halves.above)) < 1e-3 * area) return {};
  return sum / area;
}

std::optional<HalfSpace> best_plane(const Part& part, const Glow& glow) {
  Triangles few;
  const std::size_t step = part.triangles.size() / most_tried + 1;
  for (std::size_t i = 0; i < part.triangles.size(); i += step) few.push_back(part.triangles[i]);
  std::optional<HalfSpace> best;
  double least = 0;
  for (const HalfSpace& plane : candidate_planes(part.triangles))
    if (const std::optional<double> fault = fault_of(cut(few, plane), glow))
      if (!best || *fault < least * (1 - 1e-6)) best = plane, least = *fault;
  return best;
}

std::vector<EmitterPiece> split_solid(Triangles triangles, const Glow& glow, std::size_t most) {
  std::vector<Part> parts;
  parts.push_back(part_of(std::move(triangles), glow));
  while (parts.size() < most) {
    std::size_t worst = 0;
    const auto weight = [&](const Part& part) {
      return part.fault > 1 ? part.fault * area_of(part.triangles) : 0;
    };
    for (std::size_t i = 1; i < parts.size(); ++i)
      if (weight(parts[i]) > weight(parts[worst])) worst = i;
    if (!(weight(parts[worst]) > 0)) break;
    Part& part = parts[worst];
    const std::optional<HalfSpace> plane = best_plane(part, glow);
    Halves halves = plane ? cut(part.triangles, *plane) : Halves{};
    if (!(area_of(halves.below) > 0) || !(area_of(halves.above) > 0)) {
      part.fault = 0;
      continue;
    }
    part = part_of(std::move(halves.below), glow);
    parts.push_back(part_of(std::move(halves.above), glow));
  }
  std::vector<EmitterPiece> pieces;
  for (Part& part : parts) pieces.push_back(std::move(part.piece));
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
