// SPDX-License-Identifier: MIT
// Curves as chains of cones: round tubes, whatever kind they are of.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "penumbra/scene_io/numbers.h"
#include "penumbra/scene_io/pbrt_shapes.h"

namespace penumbra {
namespace {

/// Bezier control points of one piece of a curve; the last one is unused for degree 2.
using Piece = std::array<Vec3d, 4>;

/// As much memory as so many vertices and triangles.
constexpr std::size_t cost_of_cone = 4;

Vec3d mix(Vec3d a, Vec3d b, double t) { return a * (1 - t) + b * t; }

/// De Casteljau's scheme.
Vec3d point_at(const Piece& piece, std::size_t degree, double t) {
  Piece p = piece;
  for (std::size_t level = degree; level > 0; --level)
    for (std::size_t i = 0; i < level; ++i) p[i] = mix(p[i], p[i + 1], t);
  return p[0];
}

/// A piece of a uniform B-spline as a Bezier curve (blossoms at its knots).
Piece from_spline(std::span<const Vec3d> p, std::size_t degree) {
  if (degree == 2) return {(p[0] + p[1]) * 0.5, p[1], (p[1] + p[2]) * 0.5, {}};
  const Vec3d b1 = mix(p[1], p[2], 1.0 / 3), b2 = mix(p[1], p[2], 2.0 / 3);
  return {(mix(p[0], p[1], 2.0 / 3) + b1) * 0.5, b1, b2, (b2 + mix(p[2], p[3], 1.0 / 3)) * 0.5};
}

/// As many cones as keep each bend small, up to 8.
int steps_of(const Piece& piece, std::size_t degree) {
  double turn = 0;
  for (std::size_t i = 0; i + 2 <= degree; ++i) {
    const Vec3d a = normalize(piece[i + 1] - piece[i]), b = normalize(piece[i + 2] - piece[i + 1]);
    turn += std::acos(std::clamp(dot(a, b), -1.0, 1.0));
  }
  return std::clamp(static_cast<int>(std::ceil(turn / 0.2)), 1, 8);
}

std::size_t degree_of(const PbrtParams& params) {
  const double degree = params.number("degree", 3);
  if (degree != 2 && degree != 3)
    throw Error(params.place(), fmt::format("a curve of degree {}", degree), "pbrt-v4 has 2 and 3");
  return degree == 2 ? 2 : 3;
}

std::vector<Piece> pieces_of(const PbrtParams& params, std::size_t degree) {
  const std::string basis = params.text("basis", "bezier");
  if (basis != "bezier" && basis != "bspline")
    throw Error(params.place(), "unknown basis of a curve " + in_quotes(basis),
                "pbrt-v4 has bezier and bspline");
  std::vector<Vec3d> points;
  for (const Vec3f p : params.points("P")) points.push_back(Vec3d(p));
  const bool is_bezier = basis == "bezier";
  const std::size_t stride = is_bezier ? degree : 1;
  if (points.size() < degree + 1 || (points.size() - degree - 1) % stride != 0)
    throw Error(params.place(), fmt::format("a {} curve of degree {} cannot have {} points", basis,
                                            degree, points.size()));
  std::vector<Piece> pieces;
  for (std::size_t first = 0; first + degree < points.size(); first += stride) {
    const std::span<const Vec3d> p(points.data() + first, degree + 1);
    Piece piece{};
    if (is_bezier)
      std::copy(p.begin(), p.end(), piece.begin());
    else
      piece = from_spline(p, degree);
    pieces.push_back(piece);
  }
  return pieces;
}

}  // namespace

void add_pbrt_curve(PbrtScene& pbrt, const PbrtParams& params) {
  const std::size_t degree = degree_of(params);
  const double width = params.number("width", 1);
  const double from = params.number("width0", width), to = params.number("width1", width);
  if (params.text("type", "flat") != "cylinder")
    pbrt.warnings.add("flat curves and ribbons are drawn as round tubes", params.place());
  params.has("splitdepth");
  params.has("N");
  if (pbrt.graphics.area_light)
    pbrt.warnings.add("a curve that glows does not light the scene", params.place());
  const Transform& t = pbrt.graphics.to_world;
  const double scale = std::cbrt(std::abs(determinant(t)));
  const std::vector<Piece> pieces = pieces_of(params, degree);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const int steps = steps_of(pieces[i], degree);
    // Points that Attribute gives cost no bytes of the file.
    if (!params.has_own("P")) charge_made(pbrt, cost_of_cone * std::size_t(steps), params.place());
    const auto radius_at = [&](int step) {
      const double share = (static_cast<double>(i) + double(step) / steps) / double(pieces.size());
      return static_cast<float>(std::max(0.0, from + (to - from) * share) / 2 * scale);
    };
    for (int step = 0; step < steps; ++step) {
      const Cone cone{Vec3f(apply_point(t, point_at(pieces[i], degree, double(step) / steps))),
                      Vec3f(apply_point(t, point_at(pieces[i], degree, double(step + 1) / steps))),
                      radius_at(step),
                      radius_at(step + 1),
                      Caps::open,
                      pbrt.graphics.material};
      if (cone.base != cone.apex && (cone.base_radius > 0 || cone.apex_radius > 0))
        pbrt_target(pbrt).cones.push_back(cone);
    }
  }
}

}  // namespace penumbra
