// SPDX-License-Identifier: MIT
// From what a file holds to what can be rendered: the user's wishes, then sensible defaults.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "penumbra/scene/scene.h"

namespace penumbra {

/// In scene units or per cent.
struct LightRadius {
  float value = 0;
  bool is_percent = false;  ///< of the largest extent of the scene's objects
};

/// automatic: under bare models.
enum class GroundChoice { automatic, none };

/// What the user wishes; what is left out stays the file's, or a default.
struct SceneOptions {
  std::optional<Camera> camera;  ///< replaces the file's; what follows changes it
  std::optional<Vec3d> from, at, up;
  std::optional<double> fov_deg;            ///< makes a parallel camera a perspective one
  std::vector<Light> lights;                ///< if any, they replace the file's
  std::optional<LightRadius> light_radius;  ///< turns points into balls and overrides balls' radius
  std::variant<GroundChoice, double> ground = GroundChoice::automatic;  ///< or a height along `up`
  std::optional<Color> background;
  std::optional<Color> ambient;  ///< light from everywhere, without shadows
  bool clear_glass = false;      ///< transmissive materials cast no shadow
};

/// Gives the scene a camera that frames its objects, a ground (bare models), a large and a small
/// ball light, a background and ambient light where the file has none and `options` does not
/// either; then applies `options`. The scene must be validated, and is so again on return. Throws
/// Error for options that make no picture (camera at its target, a field of view outside (0, 180),
/// a light of no size where one is needed).
Scene complete_scene(Scene scene, const SceneOptions& options);

}  // namespace penumbra
