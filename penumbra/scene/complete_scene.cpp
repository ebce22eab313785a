// SPDX-License-Identifier: MIT
#include "penumbra/scene/complete_scene.h"

#include <cmath>

#include "penumbra/scene/error.h"
#include "penumbra/scene/framing.h"
#include "penumbra/scene/studio.h"

namespace penumbra {

namespace {

using detail::Subject;

bool is_field_of_view(double degrees) { return degrees > 0 && degrees < 180; }  // not for NaN

void require(bool holds, const char* problem, const char* hint) {
  if (!holds) throw Error({}, problem, hint);
}

/// Where a file has lights of its own, what they leave dark stays nearly so.
constexpr float ambient_beside_lights = 0.25f;

/// The file's camera, or one that frames the objects, as the user changes it.
Camera choose_camera(const Scene& scene, const Subject& subject, const SceneOptions& options) {
  constexpr double default_fov_deg = 35;
  const double fov_deg =
      options.fov_deg.value_or(scene.camera ? scene.camera->fov_deg : default_fov_deg);
  require(is_field_of_view(fov_deg), "the field of view is not between 0 and 180 degrees",
          "give --fov a number such as 40");

  Camera camera =
      scene.camera ? *scene.camera : detail::camera_around(scene.shapes, scene.up, fov_deg);
  // Seen from elsewhere, the middle of the objects is the better target than that of a framing.
  if (!scene.camera && options.from) camera.at = subject.center;
  if (options.from || options.at) camera.near = 0;
  if (options.from) camera.from = *options.from;
  if (options.at) camera.at = *options.at;
  if (options.up) camera.up = *options.up;
  camera.fov_deg = fov_deg;
  if (options.fov_deg) camera.parallel_height = 0;
  require(is_finite(camera.from) && is_finite(camera.at) && is_finite(camera.up),
          "the camera's place, target or up is not finite", "give --from, --at and --up numbers");
  require(normalize(camera.at - camera.from) != Vec3d{}, "the camera stands at its target",
          "give --from and --at that differ");
  return camera;
}

void add_ground(Scene& scene, const Subject& subject, double height) {
  Material material;
  material.name = "ground";
  material.diffuse = detail::studio_ground;
  const auto surface = static_cast<std::uint32_t>(scene.materials.size());
  scene.materials.push_back(material);
  scene.shapes.meshes.push_back(detail::ground(subject, scene.up, height, surface));
}

void choose_ground(Scene& scene, const Subject& subject, const SceneOptions& options) {
  if (const double* height = std::get_if<double>(&options.ground)) {
    require(std::isfinite(*height), "the ground's height is not finite", "give --ground a number");
    add_ground(scene, subject, *height);
    return;
  }
  if (!scene.wants_ground || std::get<GroundChoice>(options.ground) == GroundChoice::none) return;
  // A little below the lowest point, so that flat things do not lie in the ground's own plane.
  const double lowest = -detail::reach(scene.shapes, -scene.up);
  add_ground(scene, subject, lowest - 1e-4 * subject.extent);
}

void give_radius(std::vector<Light>& lights, LightRadius radius, double extent) {
  const double wanted = radius.is_percent ? radius.value / 100.0 * extent : radius.value;
  require(wanted > 0 && std::isfinite(wanted) && static_cast<float>(wanted) > 0,
          "the light radius is not above 0", "give --light-radius a size such as 0.1 or 5%");
  for (Light& light : lights) {
    if (const auto* point = std::get_if<PointLight>(&light.shape))
      light.shape = BallLight{point->center, static_cast<float>(wanted)};
    else if (auto* ball = std::get_if<BallLight>(&light.shape))
      ball->radius = static_cast<float>(wanted);
  }
}

}  // namespace

Scene complete_scene(Scene scene, const SceneOptions& options) {
  if (options.up) {
    require(normalize(*options.up) != Vec3d{}, "no direction is up", "give --up one that is not 0");
    scene.up = normalize(*options.up);
  }
  if (options.camera) scene.camera = options.camera;
  const Subject subject = detail::subject_of(scene.shapes);
  scene.camera = choose_camera(scene, subject, options);
  if (options.ambient)
    scene.ambient = *options.ambient;
  else if (scene.ambient == Color{})
    scene.ambient = detail::studio_ambient * (scene.lights.empty() ? 1 : ambient_beside_lights);
  if (!options.lights.empty()) scene.lights = options.lights;
  if (scene.lights.empty())
    scene.lights = detail::studio_lights(subject, scene.up, scene.camera->from);
  if (options.background) scene.background = options.background;
  if (!scene.background) scene.background = detail::studio_background;
  choose_ground(scene, subject, options);
  if (options.light_radius) give_radius(scene.lights, *options.light_radius, subject.extent);
  if (options.clear_glass)
    for (Material& material : scene.materials)
      if (max_abs(material.transmission) > 0) material.casts_shadow = false;
  validate(scene);
  return scene;
}

}  // namespace penumbra
