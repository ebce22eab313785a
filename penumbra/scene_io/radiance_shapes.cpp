// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/radiance_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "penumbra/geometry/polygon.h"
#include "penumbra/geometry/tessellation.h"
#include "penumbra/scene_io/weld.h"

namespace penumbra {
namespace {

using Kind = RadianceShape::Kind;

Vec3d vector_at(const RadiancePrimitive& p, std::size_t i) {
  return {p.numbers[i], p.numbers[i + 1], p.numbers[i + 2]};
}

[[noreturn]] void fail(const RadianceFile& file, const RadiancePrimitive& p, const char* what,
                       const char* hint) {
  throw Error({file.path.string(), p.line, {}}, fmt::format("{} '{:.40}' {}", p.type, p.name, what),
              hint);
}

void read_sphere(const RadiancePrimitive& p, RadianceShape& shape) {
  shape.a = vector_at(p, 0);
  shape.r0 = std::abs(p.numbers[3]);
  if (p.numbers[3] < 0) shape.faces_inward = !shape.faces_inward;
  if (shape.r0 > 0) shape.kind = Kind::sphere;
}

void read_cone(const RadianceFile& file, const RadiancePrimitive& p, RadianceShape& shape) {
  const bool is_cylinder = p.type == "cylinder" || p.type == "tube";
  shape.a = vector_at(p, 0), shape.b = vector_at(p, 3);
  const double r0 = p.numbers[6], r1 = is_cylinder ? r0 : p.numbers[7];
  if (r0 * r1 < 0) fail(file, p, "has a radius above 0 and one below", "give both the same sign");
  if (r0 < 0 || r1 < 0) shape.faces_inward = !shape.faces_inward;
  shape.r0 = std::abs(r0), shape.r1 = std::abs(r1);
  if (std::max(shape.r0, shape.r1) > 0 && shape.a != shape.b) shape.kind = Kind::cone;
}

void read_ring(const RadianceFile& file, const RadiancePrimitive& p, RadianceShape& shape) {
  shape.a = vector_at(p, 0), shape.b = normalize(vector_at(p, 3));
  shape.r0 = std::min(p.numbers[6], p.numbers[7]), shape.r1 = std::max(p.numbers[6], p.numbers[7]);
  if (shape.r0 < 0) fail(file, p, "has a radius below 0", "give radii from 0 up");
  if (shape.b == Vec3d{}) fail(file, p, "has no normal", "give a direction that is not 0");
  if (shape.r1 > shape.r0) shape.kind = Kind::ring;
}

void read_polygon(const RadianceFile& file, const RadiancePrimitive& p, RadianceShape& shape) {
  if (p.numbers.size() < 9 || p.numbers.size() % 3 != 0)
    fail(file, p, "needs three numbers a corner, and three corners or more", "check its count");
  for (std::size_t i = 0; i < p.numbers.size(); i += 3) shape.corners.push_back(vector_at(p, i));
  shape.kind = Kind::polygon;
}

std::uint32_t next_vertex(const Mesh& mesh, std::size_t added) {
  if (mesh.positions.size() + added >= std::numeric_limits<std::uint32_t>::max())
    throw Error({}, "its polygons have more corners than 32 bits can count", "split the scene");
  return static_cast<std::uint32_t>(mesh.positions.size());
}

void add_triangle(Mesh& mesh, Triangle t, bool is_turned, std::uint32_t surface) {
  if (is_turned) std::swap(t[1], t[2]);
  mesh.triangles.push_back(t);
  mesh.surfaces.push_back(surface);
}

void add_polygon(Mesh& mesh, const RadianceShape& shape, std::uint32_t surface) {
  std::vector<Vec3f> corners;
  for (Vec3d c : shape.corners) corners.emplace_back(c);
  const std::uint32_t base = next_vertex(mesh, corners.size());
  mesh.positions.insert(mesh.positions.end(), corners.begin(), corners.end());
  const std::vector<Triangle> triangles =
      corners.size() == 3 ? std::vector<Triangle>{{0, 1, 2}} : triangulate(corners);
  for (const Triangle& t : triangles)
    add_triangle(mesh, {base + t[0], base + t[1], base + t[2]}, shape.faces_inward, surface);
}

}  // namespace

RadianceShape radiance_shape(const RadianceFile& file, const RadiancePrimitive& p,
                             RadianceSide side) {
  const std::string& type = p.type;
  RadianceShape shape;
  shape.faces_inward =
      (type == "bubble" || type == "tube" || type == "cup") != (side == RadianceSide::inverted);
  if (type == "polygon") {
    read_polygon(file, p, shape);
  } else {
    const std::size_t numbers = type == "sphere" || type == "bubble"   ? 4
                                : type == "cylinder" || type == "tube" ? 7
                                                                       : 8;
    require_numbers(file, p, numbers, numbers);
    if (numbers == 4)
      read_sphere(p, shape);
    else if (type == "ring")
      read_ring(file, p, shape);
    else
      read_cone(file, p, shape);
  }
  return shape;
}

RadianceShape placed(RadianceShape shape, const Transform& map) {
  const double det = determinant(map), scale = std::cbrt(std::abs(det));
  shape.a = apply_point(map, shape.a);
  shape.b = shape.kind == Kind::ring ? normalize(apply_direction(map, shape.b))
                                     : apply_point(map, shape.b);
  shape.r0 *= scale, shape.r1 *= scale;
  for (Vec3d& c : shape.corners) c = apply_point(map, c);
  // A mirror reverses the sense of a polygon's corners.
  if (shape.kind == Kind::polygon && det < 0) shape.faces_inward = !shape.faces_inward;
  return shape;
}

std::optional<double> mean_chord(const RadianceShape& shape) {
  if (shape.kind == Kind::sphere) return 4.0 / 3.0 * shape.r0;
  if (shape.kind == Kind::cone) return shape.r0 + shape.r1;
  return std::nullopt;
}

void add_shape(ShapeSet& shapes, Mesh& polygons, const RadianceShape& shape,
               std::uint32_t surface) {
  switch (shape.kind) {
    case Kind::none: return;
    case Kind::sphere:
      shapes.spheres.push_back({Vec3f(shape.a), static_cast<float>(shape.r0), surface});
      return;
    case Kind::cone:
      shapes.cones.push_back({Vec3f(shape.a), Vec3f(shape.b), static_cast<float>(shape.r0),
                              static_cast<float>(shape.r1), Caps::open, surface});
      return;
    case Kind::ring:
      shapes.rings.push_back({Vec3f(shape.a), Vec3f(shape.faces_inward ? -shape.b : shape.b),
                              static_cast<float>(shape.r1), static_cast<float>(shape.r0), surface});
      return;
    case Kind::polygon: add_polygon(polygons, shape, surface); return;
  }
}

void add_faceted(Mesh& mesh, const RadianceShape& shape, std::uint32_t surface) {
  // Thousands of lamps are seen from far away.
  constexpr std::size_t many = 100'000;
  const int segments = mesh.triangles.size() < many ? 24 : 8;
  const bool turned = shape.faces_inward;
  const auto r0 = static_cast<float>(shape.r0), r1 = static_cast<float>(shape.r1);
  const bool is_ring = shape.kind == Kind::ring;
  const Mesh part =
      is_ring
          ? tessellated(Ring{Vec3f(shape.a), Vec3f(turned ? -shape.b : shape.b), r1, r0, 0},
                        segments)
          : tessellated(Cone{Vec3f(shape.a), Vec3f(shape.b), r0, r1, Caps::capped, 0}, segments);
  const std::uint32_t base = next_vertex(mesh, part.positions.size());
  mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
  for (const Triangle& t : part.triangles)
    add_triangle(mesh, {base + t[0], base + t[1], base + t[2]}, turned && !is_ring, surface);
}

void finish_polygons(ShapeSet& shapes, Mesh polygons) {
  if (polygons.triangles.empty()) return;
  weld(polygons);
  const std::uint32_t first = polygons.surfaces[0];
  if (std::all_of(polygons.surfaces.begin(), polygons.surfaces.end(),
                  [&](std::uint32_t surface) { return surface == first; })) {
    polygons.surface = first;
    polygons.surfaces.clear();
  }
  shapes.meshes.push_back(std::move(polygons));
}

}  // namespace penumbra
