// SPDX-License-Identifier: MIT
// Head and shoulders on a plinth: one closed mesh with fine relief, one light.
#include <cmath>

#include "penumbra/scene/bust_shape.h"
#include "penumbra/scene/gallery_scenes.h"
#include "penumbra/scene/surface_nets.h"

namespace penumbra::detail {

namespace {

/// Planes from low to high whose spacing is `fine` around `focus` and grows to `coarse` away from
/// it.
std::vector<double> graded_planes(double low, double high, double focus, double reach, double fine,
                                  double coarse) {
  std::vector<double> planes;
  for (double x = low; x < high;) {
    planes.push_back(x);
    const double away = (x - focus) / reach;
    x += coarse + (fine - coarse) * std::exp(-away * away);
  }
  planes.push_back(high);
  return planes;
}

}  // namespace

Scene bust_scene() {
  Scene scene;
  const double h = 0.03099;
  const GridPlanes planes{graded_planes(-1.75, 1.75, 0, 0.5, 0.75 * h, 1.25 * h),
                          graded_planes(-1.3, 1.35, -0.8, 0.5, 0.75 * h, 1.25 * h),
                          graded_planes(bust_bottom - 0.1, 2.6, 0.9, 0.6, 0.75 * h, 1.25 * h)};
  scene.shapes.meshes.push_back(surface_nets(planes, bust_field, bust_steepness));
  Material stone = matte("stone", {0.72f, 0.68f, 0.6f});
  stone.highlight = {0.06f, 0.06f, 0.06f};
  stone.shininess = 12;
  scene.materials = {stone, matte("ground", {0.5f, 0.51f, 0.53f})};
  const auto floor = static_cast<float>(bust_bottom);
  scene.shapes.meshes.push_back(backdrop_quad({-150, -150, floor}, {150, -150, floor},
                                              {150, 150, floor}, {-150, 150, floor}, 1));
  Camera camera;
  camera.at = {0, 0.1, -0.42};
  camera.from = {3.4, -9.6, 1.5};
  camera.fov_deg = 33;
  scene.camera = camera;
  scene.background = Color{0.1f, 0.105f, 0.115f};
  scene.ambient = {0.16f, 0.16f, 0.17f};
  scene.lights = {ball_light({-4.2f, -10, 7.5f}, 0.8f, 0.85f)};
  return scene;
}

}  // namespace penumbra::detail
