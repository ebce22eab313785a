// SPDX-License-Identifier: MIT
#include "penumbra/scene/emitters.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "penumbra/scene/emitter_join.h"
#include "penumbra/scene/emitter_piece.h"
#include "penumbra/scene/emitter_split.h"
#include "penumbra/scene/glowing_surface.h"

namespace penumbra {
namespace {

bool glows(const Material& material) { return max_abs(material.emission) > 0; }

/// The part that a surface has in the power of all.
std::vector<double> shares_of(std::span<const GlowingSurface> surfaces) {
  std::vector<double> shares;
  double sum = 0;
  for (const GlowingSurface& surface : surfaces) {
    const Color c = surface.radiance;
    shares.push_back(
        area_of(surface.triangles) *
        (static_cast<double>(c.x) + static_cast<double>(c.y) + static_cast<double>(c.z)));
    sum += shares.back();
  }
  for (double& share : shares) share /= sum;
  return shares;
}

/// Few surfaces are cut as finely as they ask for; of many, those that shine most.
std::vector<EmitterPiece> pieces_of(std::span<const GlowingSurface> surfaces,
                                    const EmitterOptions& options) {
  const std::vector<double> shares = shares_of(surfaces);
  std::vector<EmitterPiece> pieces;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    std::size_t most = options.most_a_surface;
    if (surfaces.size() > options.most_lights) {
      const double wanted = 2 * shares[i] * static_cast<double>(options.most_lights);
      most = static_cast<std::size_t>(
          std::clamp(wanted, 1.0, static_cast<double>(options.most_a_surface)));
    }
    for (EmitterPiece& piece : split(surfaces[i], most)) {
      piece.surface = i;
      pieces.push_back(std::move(piece));
    }
  }
  return pieces;
}

/// Gives the glowing triangles their materials' twins that cast no shadow.
class Clearing {
 public:
  explicit Clearing(Scene& scene) : scene_(scene), twin_of_(scene.materials.size()) {}

  void clear(ShapeSet& shapes) {
    for (Mesh& mesh : shapes.meshes) clear(mesh);
  }

 private:
  void clear(Mesh& mesh) {
    if (mesh.surfaces.empty()) {
      mesh.surface = cleared(mesh.surface);
      return;
    }
    for (std::uint32_t& surface : mesh.surfaces) surface = cleared(surface);
  }

  std::uint32_t cleared(std::uint32_t surface) {
    if (surface >= twin_of_.size()) return surface;
    if (!glows(scene_.materials[surface]) || !scene_.materials[surface].casts_shadow)
      return surface;
    if (twin_of_[surface] == 0) {
      twin_of_[surface] = static_cast<std::uint32_t>(scene_.materials.size());
      Material twin = scene_.materials[surface];
      twin.casts_shadow = false;
      scene_.materials.push_back(std::move(twin));
    }
    return twin_of_[surface];
  }

  Scene& scene_;
  std::vector<std::uint32_t> twin_of_;  ///< 0: none yet
};

}  // namespace

EmitterReport add_emitter_lights(Scene& scene, const EmitterOptions& options) {
  if (std::none_of(scene.materials.begin(), scene.materials.end(), glows)) return {};
  const std::vector<GlowingSurface> surfaces = glowing_surfaces(scene);
  EmitterReport report;
  report.surfaces = surfaces.size();
  if (surfaces.empty()) return report;

  const std::vector<EmitterPiece> pieces = pieces_of(surfaces, options);
  std::vector<bool> is_joined(surfaces.size()), is_lit(surfaces.size());
  double sent = 0, astray = 0;
  const std::vector<std::vector<std::size_t>> groups =
      groups_of(pieces, std::max<std::size_t>(options.most_lights, 1));
  // A corner costs each point that asks for the light some 0.2 microseconds.
  const std::size_t most_corners = std::clamp<std::size_t>(128 / groups.size(), 12, 32);
  for (const std::vector<std::size_t>& group : groups) {
    const EmitterPiece piece = joined(pieces, group);
    const std::optional<Light> light = light_of(piece, most_corners);
    if (!light) continue;
    scene.lights.push_back(*light);
    ++report.lights;
    sent += total(piece.field);
    astray += misdirected(piece.field, field_of(*light));
    const bool is_shared = pieces[group.front()].surface != pieces[group.back()].surface;
    for (const std::size_t i : group) {
      is_lit[pieces[i].surface] = true;
      if (is_shared) is_joined[pieces[i].surface] = true;
    }
  }
  const auto count = [](const std::vector<bool>& flags, bool value) {
    return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), value));
  };
  report.joined = count(is_joined, true);
  report.dark = count(is_lit, false);
  report.misdirected = sent > 0 ? astray / sent : 0;
  if (report.lights > 0) {
    Clearing clearing(scene);
    clearing.clear(scene.shapes);
    for (ShapeSet& group : scene.shapes.groups) clearing.clear(group);
  }
  return report;
}

}  // namespace penumbra
