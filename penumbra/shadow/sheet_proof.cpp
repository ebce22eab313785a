// SPDX-License-Identifier: MIT
#include "penumbra/shadow/sheet_proof.h"

#include "penumbra/kernel/kernel.h"

namespace penumbra {
namespace {

constexpr std::uint32_t outline_rays = 8;

/// Whether rays to the light's outline are all blocked: where one is not, no proof is looked for.
bool is_outline_hidden(const Kernel& kernel, const SeenLight& sight, LightSamples& rays,
                       std::uint64_t& tests) {
  constexpr float diagonal = 0.70710678f;
  constexpr float turns[outline_rays][2] = {
      {1, 0},  {diagonal, diagonal},   {0, 1},  {-diagonal, diagonal},
      {-1, 0}, {-diagonal, -diagonal}, {0, -1}, {diagonal, -diagonal}};
  rays.resize(outline_rays);
  rays.origin = sight.p, rays.t_max = 1;
  const Frame<float> frame = frame_around(sight.way / sight.distance);
  for (std::size_t i = 0; i < rays.x.size(); ++i) {
    const float* turn = turns[i % outline_rays];
    const Vec3f way = sight.way + (frame.u * turn[0] + frame.v * turn[1]) * sight.light->size;
    rays.x[i] = way.x, rays.y[i] = way.y, rays.z[i] = way.z;
  }
  const std::uint32_t active[] = {(1u << outline_rays) - 1};
  std::uint32_t blocked[1];
  tests += kernel.occluded(rays, active, blocked).tests;
  return blocked[0] == active[0];
}

}  // namespace

bool is_behind_sheet(const ShadowScene& scene, const SeenLight& sight, std::uint32_t most_triangles,
                     LightSamples& outline, SheetScratch& scratch, std::uint64_t& tests) {
  const Kernel& kernel = *scene.kernel;
  Ray ray{sight.p, sight.way};
  ray.t_max = 1;
  const std::uint32_t nearest = kernel.closest_record(ray);
  if (nearest == no_record || kernel.records()[nearest].kind != ShapeKind::triangle ||
      !is_outline_hidden(kernel, sight, outline, tests))
    return false;
  const auto covers = [&](std::uint32_t start) {
    return sheet_covers(*scene.sheet, kernel.records(), sight, start, most_triangles, scratch,
                        tests);
  };
  if (covers(nearest)) return true;
  const std::uint32_t last = kernel.closest_record({sight.p + sight.way, -sight.way, 0, 1});
  return last != no_record && last != nearest && covers(last);
}

}  // namespace penumbra
