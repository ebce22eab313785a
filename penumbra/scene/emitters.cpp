// SPDX-License-Identifier: MIT
#include "penumbra/scene/emitters.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <numeric>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <vector>

namespace penumbra {

namespace {

constexpr std::size_t most_lights = 64;
/// Of the longer diagonal: how far the fourth corner may lie from where a parallelogram has it.
constexpr double corner_tolerance = 1e-3;

/// Glowing triangles of one mesh that hang together by positions and share a material.
struct Part {
  std::size_t mesh = 0;
  std::uint32_t material = 0;
  std::vector<std::uint32_t> triangles;
};

struct Emitter {
  Part part;
  Light light;
  double power = 0;  ///< to compare by
};

bool glows(const Material& material) { return max_abs(material.emission) > 0; }

struct PositionHash {
  std::size_t operator()(Vec3f p) const {
    std::uint64_t h = 0;
    for (float c : {p.x, p.y, p.z})  // + 0 makes -0 equal to 0, as == has it
      h = (h ^ std::bit_cast<std::uint32_t>(c + 0.0f)) * 0x9E3779B97F4A7C15u, h ^= h >> 32;
    return h;
  }
};

std::uint32_t root(std::vector<std::uint32_t>& parents, std::uint32_t i) {
  while (parents[i] != i) i = parents[i] = parents[parents[i]];
  return i;
}

/// The glowing parts of one mesh.
std::vector<Part> glowing_parts(const Scene& scene, std::size_t mesh_index) {
  const Mesh& mesh = scene.shapes.meshes[mesh_index];
  std::vector<std::uint32_t> glowing;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    if (surface_of(mesh, t) < scene.materials.size() && glows(scene.materials[surface_of(mesh, t)]))
      glowing.push_back(t);

  std::vector<std::uint32_t> parents(glowing.size());
  std::iota(parents.begin(), parents.end(), 0u);
  std::unordered_map<Vec3f, std::uint32_t, PositionHash> first_at;
  for (std::uint32_t i = 0; i < glowing.size(); ++i)
    for (std::uint32_t corner : mesh.triangles[glowing[i]]) {
      const auto [at, is_new] = first_at.try_emplace(mesh.positions[corner], i);
      if (!is_new) parents[root(parents, i)] = root(parents, at->second);
    }

  std::unordered_map<std::uint32_t, std::size_t> part_of_root;
  std::vector<Part> parts;
  for (std::uint32_t i = 0; i < glowing.size(); ++i) {
    const std::uint32_t material = surface_of(mesh, glowing[i]);
    const auto [at, is_new] = part_of_root.try_emplace(root(parents, i), parts.size());
    if (is_new) parts.push_back({mesh_index, material, {}});
    Part& part = parts[at->second];
    part.triangles.push_back(glowing[i]);
  }
  return parts;
}

/// The parallelogram that two triangles make, if they make one of even brightness.
std::optional<ParallelogramLight> parallelogram(const Scene& scene, const Part& part) {
  const Mesh& mesh = scene.shapes.meshes[part.mesh];
  if (part.triangles.size() != 2 || surface_of(mesh, part.triangles[1]) != part.material)
    return std::nullopt;
  std::array<std::array<Vec3f, 3>, 2> corners;
  for (std::size_t t = 0; t < 2; ++t)
    for (std::size_t i = 0; i < 3; ++i)
      corners[t][i] = mesh.positions[mesh.triangles[part.triangles[t]][i]];
  const auto is_of = [](const std::array<Vec3f, 3>& triangle, Vec3f p) {
    return std::find(triangle.begin(), triangle.end(), p) != triangle.end();
  };
  for (std::size_t i = 0; i < 3; ++i) {
    // a is the corner that the triangles do not share, b and d the diagonal, c the other one.
    const Vec3f a = corners[0][i], b = corners[0][(i + 1) % 3], d = corners[0][(i + 2) % 3];
    if (is_of(corners[1], a) || !is_of(corners[1], b) || !is_of(corners[1], d)) continue;
    const auto c = std::find_if(corners[1].begin(), corners[1].end(),
                                [&](Vec3f p) { return p != b && p != d; });
    if (c == corners[1].end()) return std::nullopt;
    const Vec3d opposite = Vec3d(b) + Vec3d(d) - Vec3d(a);
    const double size = std::max(length(Vec3d(b) - Vec3d(d)), length(Vec3d(a) - Vec3d(*c)));
    if (!(length(opposite - Vec3d(*c)) <= corner_tolerance * size)) return std::nullopt;
    const Vec3d u = (Vec3d(b) - Vec3d(a)) * 0.5, v = (Vec3d(d) - Vec3d(a)) * 0.5;
    if (!(length(cross(u, v)) > 0)) return std::nullopt;
    return ParallelogramLight{Vec3f((Vec3d(b) + Vec3d(d)) * 0.5), Vec3f(u), Vec3f(v)};
  }
  return std::nullopt;
}

/// Gives the part's triangles their material's twin that casts no shadow; `twins` has it or gets
/// it.
void clear_shadow(Scene& scene, const Part& part,
                  std::unordered_map<std::uint32_t, std::uint32_t>& twins) {
  const auto [twin, is_new] =
      twins.try_emplace(part.material, static_cast<std::uint32_t>(scene.materials.size()));
  if (is_new) {
    scene.materials.push_back(scene.materials[part.material]);
    scene.materials.back().casts_shadow = false;
  }
  Mesh& mesh = scene.shapes.meshes[part.mesh];
  if (mesh.surfaces.empty()) mesh.surfaces.assign(mesh.triangles.size(), mesh.surface);
  for (std::uint32_t t : part.triangles) mesh.surfaces[t] = twin->second;
}

}  // namespace

EmitterReport add_emitter_lights(Scene& scene) {
  if (std::none_of(scene.materials.begin(), scene.materials.end(), glows)) return {};
  std::size_t parts = 0;
  std::vector<Emitter> emitters;
  for (std::size_t m = 0; m < scene.shapes.meshes.size(); ++m)
    for (Part& part : glowing_parts(scene, m)) {
      ++parts;
      const auto shape = parallelogram(scene, part);
      if (!shape) continue;
      // Radiant intensity along the normal is radiance times area.
      const float area = 4 * length(cross(shape->u, shape->v));
      const Color intensity = scene.materials[part.material].emission * area;
      emitters.push_back({std::move(part),
                          {*shape, intensity, Falloff::inverse_square},
                          static_cast<double>(max_abs(intensity))});
    }
  if (emitters.size() > most_lights) {
    std::stable_sort(emitters.begin(), emitters.end(),
                     [](const Emitter& a, const Emitter& b) { return a.power > b.power; });
    emitters.resize(most_lights);
  }
  std::unordered_map<std::uint32_t, std::uint32_t> twins;
  for (const Emitter& emitter : emitters) {
    clear_shadow(scene, emitter.part, twins);
    scene.lights.push_back(emitter.light);
  }
  return {parts, emitters.size(), 0, parts - emitters.size(), 0};
}

}  // namespace penumbra
