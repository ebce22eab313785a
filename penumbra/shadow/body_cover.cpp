// SPDX-License-Identifier: MIT
#include "penumbra/shadow/body_cover.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace penumbra {
namespace {

/// Shaft and polyhedron in coordinates around its centre, scaled up by so much that the polyhedron
/// itself takes the place of what is left of it when it shrinks by the margin.
struct View {
  const ConvexPolyhedron& body;
  const LightHull& light;
  Vec3d p, c;
  double scale, doubt;
  double far;  // no coordinate is larger

  /// The largest dot(n, l) over the light.
  double most(Vec3d n) const {
    return dot(n, c) + scale * dot(n, light.spread(n)) + doubt * length(n);
  }
};

constexpr std::size_t most_faces = 64;

/// Faces that p sees, as bits, if the segment from p to c has a point in the polyhedron: most
/// volumes fail here.
struct Sighting {
  std::uint64_t seen = 0;
  bool is_met = false;
};

Sighting center_line(const View& view) {
  Sighting result;
  double from = 0, to = 1;
  for (std::size_t i = 0; i < view.body.faces.size(); ++i) {
    const HalfSpace& face = view.body.faces[i];
    const double at_p = dot(face.normal, view.p) - face.offset;
    const double at_c = dot(face.normal, view.c) - face.offset;
    if (at_p > 0) {
      if (at_c > 0) return result;
      result.seen |= std::uint64_t{1} << i;
      from = std::max(from, at_p / (at_p - at_c));
    } else if (at_c > 0) {
      to = std::min(to, at_p / (at_p - at_c));
    }
    if (!(from <= to)) return result;
  }
  result.is_met = true;
  return result;
}

/// Whether the light lies on the polyhedron's side of the plane through p and an edge of the
/// outline. The normal's error is that of its two factors.
bool is_behind(const View& view, const ConvexPolyhedron::Edge& edge) {
  const Vec3d a = edge.a - view.p, b = edge.b - view.p;
  Vec3d normal = cross(a, b);
  double at_p = dot(normal, view.p);
  if (at_p < 0) normal = -normal, at_p = -at_p;  // the centre, 0, is on the side of the polyhedron
  const double error = 1e-14 * length(a) * length(b) * view.far;
  return view.most(normal) < at_p - error;
}

}  // namespace

bool body_covers(const ConvexPolyhedron& body, Vec3d center, const LightShaft& shaft, double margin,
                 double doubt) {
  const double share = margin / body.inner;
  if (body.is_empty() || body.faces.size() > most_faces || !(share < 0.5)) return false;
  const double scale = 1 / (1 - share);
  View view{body,
            shaft.light,
            (shaft.p - center) * scale,
            (shaft.c - center) * scale,
            scale,
            doubt * scale,
            0};
  view.far = length(view.p) + length(view.c) + scale * shaft.light.size() + view.doubt + body.outer;
  const Sighting sighting = center_line(view);
  if (!sighting.is_met) return false;
  const auto sees = [&](std::uint32_t face) { return sighting.seen >> face & 1; };
  for (const ConvexPolyhedron::Edge& edge : body.edges)
    if (sees(edge.face[0]) != sees(edge.face[1]) && !is_behind(view, edge)) return false;
  for (std::uint32_t i = 0; i < body.faces.size(); ++i)
    if (sees(i) && !(view.most(body.faces[i].normal) < body.faces[i].offset)) return false;
  return true;
}

ShaftWidth::ShaftWidth(const LightShaft& shaft) : p(shaft.p) {
  const Vec3d way = shaft.c - shaft.p;
  const double square = length_squared(way);
  length = std::sqrt(square);
  axis = way / square;
  const Frame<double> frame = frame_around(way / length);
  out = {frame.u, -frame.u, frame.v, -frame.v};
  for (std::size_t i = 0; i < out.size(); ++i) reach[i] = dot(out[i], shaft.light.spread(out[i]));
}

}  // namespace penumbra
