// SPDX-License-Identifier: MIT
// What is to be drawn. Plain data: indices, not pointers, so that it copies and prints.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "penumbra/geometry/shape.h"
#include "penumbra/scene/camera.h"
#include "penumbra/scene/light.h"
#include "penumbra/scene/material.h"

namespace penumbra {

/// Shapes' `surface` indexes `materials`; there is at least one material once validated.
/// What a file does not give (camera, lights, background, ground) stays empty until
/// `complete_scene`.
struct Scene {
  std::string name;
  ShapeSet shapes;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<Light> lights;
  std::optional<Camera> camera;
  std::optional<Color> background;
  Color ambient{};    ///< light from everywhere, unshadowed; multiplies `diffuse`
  Vec3d up{0, 0, 1};  ///< which way is up, for ground and framing; z unless the format says y
  bool wants_ground = false;  ///< a bare model: put a ground under it unless told otherwise
};

/// What `validate` dropped.
struct ValidationReport {
  std::size_t degenerate_triangles = 0;
};

/// Checks and mends a scene from any source; after it, kernel, shadow and trace need no checks.
/// Throws Error (place: the scene's name) where a coordinate is not finite or beyond 1e15, a radius
/// is
/// <= 0, an index is out of range, an array has the wrong length, or nothing can be hit. Drops
/// degenerate triangles and counts them; makes directions unit length; gives a scene without
/// materials one. Texture coordinates may be anything.
ValidationReport validate(Scene& scene);

}  // namespace penumbra
