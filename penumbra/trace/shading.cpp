// SPDX-License-Identifier: MIT
#include "penumbra/trace/shading.h"

#include <cmath>
#include <utility>

#include "penumbra/geometry/irradiance.h"
#include "penumbra/geometry/placed_shape.h"

namespace penumbra {
namespace {

/// Vertex values weighted by where the point lies in the triangle.
template <typename T>
T interpolate(const std::vector<T>& values, const Triangle& corner, const double* weight) {
  return values[corner[0]] * static_cast<float>(weight[0]) +
         values[corner[1]] * static_cast<float>(weight[1]) +
         values[corner[2]] * static_cast<float>(weight[2]);
}

Vec2f interpolate_uv(const std::vector<Vec2f>& uvs, const Triangle& corner, const double* weight) {
  Vec2f uv;
  for (int i = 0; i < 3; ++i) {
    uv.u += uvs[corner[i]].u * static_cast<float>(weight[i]);
    uv.v += uvs[corner[i]].v * static_cast<float>(weight[i]);
  }
  return uv;
}

/// Of a placed mesh, each vertex normal as `transformed` would have it.
Vec3f interpolate_placed(const Mesh& mesh, const Triangle& corner, const double* weight,
                         const Transform& map) {
  Vec3f sum;
  for (int i = 0; i < 3; ++i)
    sum += placed_normal(map, mesh.normals[corner[i]]) * static_cast<float>(weight[i]);
  return sum;
}

void add_mesh_attributes(const Scene& scene, ShapeRef shape, ShadingPoint& point) {
  const Mesh& mesh = home_of(scene.shapes, shape).meshes[shape.index];
  const Transform* map =
      shape.instance == 0 ? nullptr : &scene.shapes.instances[shape.instance - 1].placement;
  Triangle corner = mesh.triangles[shape.triangle];
  if (map && determinant(*map) < 0) std::swap(corner[1], corner[2]);  // as `corners` has them
  const double* weight = point.surface.barycentric;
  if (!mesh.normals.empty()) {
    const Vec3f n = normalize(map ? interpolate_placed(mesh, corner, weight, *map)
                                  : interpolate(mesh.normals, corner, weight));
    if (dot(n, n) > 0.5f) point.shading_normal = dot(n, point.normal) < 0 ? -n : n;
  }
  if (!mesh.colors.empty())
    point.diffuse = point.diffuse * interpolate(mesh.colors, corner, weight);
  if (!mesh.uvs.empty() && point.material->texture >= 0)
    point.diffuse =
        point.diffuse * sample(scene.textures[static_cast<std::size_t>(point.material->texture)],
                               interpolate_uv(mesh.uvs, corner, weight));
}

/// Share that remains of a light's reflection where shading and geometric normal differ.
float terminator(const ShadingPoint& point, Vec3f to_light) {
  if (point.shading_normal == point.normal) return 1;
  const float geometric = dot(to_light, point.normal),
              shading = dot(to_light, point.shading_normal);
  if (!(geometric > 0) || !(shading > 0)) return 0;
  const float g = std::min(1.0f, geometric / (shading * dot(point.normal, point.shading_normal)));
  return g >= 0 ? (1 + g - g * g) * g : 0;
}

}  // namespace

ShadingPoint shading_point(const Scene& scene, ShapeRef shape, Vec3d origin, Vec3d direction,
                           double t) {
  ShadingPoint point;
  point.surface = surface_point(scene.shapes, shape, origin, direction, t);
  point.receiver = receiver_position(point.surface);
  point.normal = normalize(Vec3f(point.surface.normal));
  point.shading_normal = point.normal;
  point.to_viewer = normalize(Vec3f(-direction));
  point.material = &scene.materials[surface_of(scene.shapes, shape)];
  point.diffuse = point.material->diffuse;
  if (shape.kind == ShapeKind::triangle) add_mesh_attributes(scene, shape, point);
  return point;
}

Color emitted(const ShadingPoint& point) {
  const Material& material = *point.material;
  return material.emits_from_back || !point.surface.is_back ? material.emission : Color{};
}

Color unshadowed(const Light& light, const ShadingPoint& point) {
  const Vec3f to_light = normalize(towards_center(light.shape, point.receiver));
  double strength = terminator(point, to_light) * beam_factor(light, point.receiver);
  if (light.falloff == Falloff::inverse_square)
    strength *= inverse_square_factor(light.shape, point.receiver);
  const auto cosine =
      static_cast<float>(irradiance(light.shape, point.receiver, point.shading_normal));
  Color reflected = point.diffuse * cosine;
  const Material& material = *point.material;
  if (max_abs(material.highlight) > 0 && dot(to_light, point.shading_normal) > 0) {
    const Vec3f n = point.shading_normal;
    const Vec3f mirror = n * (2 * dot(n, point.to_viewer)) - point.to_viewer;
    reflected +=
        material.highlight * std::pow(std::max(0.0f, dot(mirror, to_light)), material.shininess);
  }
  return reflected * light.intensity * static_cast<float>(strength);
}

Vec3f mirrored_direction(const ShadingPoint& point) {
  const auto about = [&](Vec3f n) { return n * (2 * dot(n, point.to_viewer)) - point.to_viewer; };
  const Vec3f direction = about(point.shading_normal);
  return dot(direction, point.normal) > 0 ? direction
                                          : about(point.normal);  // never into the surface
}

std::optional<Vec3f> refracted_direction(const ShadingPoint& point) {
  const float index = point.material->refraction_index;
  const float eta = point.surface.is_back ? index : 1 / index;
  const auto about = [&](Vec3f n) -> std::optional<Vec3f> {
    const float cosine = dot(n, point.to_viewer);
    const float square = 1 - eta * eta * (1 - cosine * cosine);
    if (!(square >= 0)) return {};
    return n * (eta * cosine - std::sqrt(square)) - point.to_viewer * eta;
  };
  const std::optional<Vec3f> direction = about(point.shading_normal);
  return direction && dot(*direction, point.normal) >= 0 ? about(point.normal)  // never back out
                                                         : direction;
}

}  // namespace penumbra
