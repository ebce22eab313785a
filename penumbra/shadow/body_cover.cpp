// SPDX-License-Identifier: MIT
#include "penumbra/shadow/body_cover.h"

#include <algorithm>
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

/// Whether the segment from p to c has a point in the polyhedron: most volumes fail here.
bool center_line_meets(const View& view) {
  double from = 0, to = 1;
  for (const HalfSpace& face : view.body.faces) {
    const double at_p = dot(face.normal, view.p) - face.offset;
    const double at_c = dot(face.normal, view.c) - face.offset;
    if (at_p > 0 && at_c > 0) return false;
    if (at_p > 0) from = std::max(from, at_p / (at_p - at_c));
    if (at_c > 0) to = std::min(to, at_p / (at_p - at_c));
  }
  return from <= to;
}

bool sees(const View& view, std::uint32_t face) {
  return dot(view.body.faces[face].normal, view.p) > view.body.faces[face].offset;
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
  if (body.is_empty() || !(share < 0.5)) return false;
  const double scale = 1 / (1 - share);
  View view{body,
            shaft.light,
            (shaft.p - center) * scale,
            (shaft.c - center) * scale,
            scale,
            doubt * scale,
            0};
  view.far = length(view.p) + length(view.c) + scale * shaft.light.size() + view.doubt + body.outer;
  if (!center_line_meets(view)) return false;
  for (const HalfSpace& face : body.faces)
    if (dot(face.normal, view.p) > face.offset && !(view.most(face.normal) < face.offset))
      return false;
  for (const ConvexPolyhedron::Edge& edge : body.edges)
    if (sees(view, edge.face[0]) != sees(view, edge.face[1]) && !is_behind(view, edge))
      return false;
  return true;
}

}  // namespace penumbra
