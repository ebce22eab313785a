// SPDX-License-Identifier: MIT
// Files in, pictures out, for programs that link the library. With penumbra.h it is all that they
// include; none of it needs a header of another library.
//
//   penumbra::Renderer renderer(complete_scene(penumbra::find_scene("bust.ply").scene, {}));
//   penumbra::Picture picture = renderer.render({.shadow_samples = 64});
//   penumbra::write_image("bust.png", picture.image);
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "penumbra/scene/complete_scene.h"
#include "penumbra/scene/error.h"
#include "penumbra/scene/scene.h"
#include "penumbra/scene_io/image_io.h"
#include "penumbra/scene_io/read_scene.h"
#include "penumbra/shadow/method.h"
#include "penumbra/trace/picture.h"
#include "penumbra/visibility/scene_occluders.h"

namespace penumbra {

/// The built-in scene of that name; throws Error with the names there are.
Scene load_built_in_scene(const std::string& name);

/// The file of that name, if there is one, else the built-in scene (`cylinders`, `balls:N`,
/// `rings`, `molecule`, `bust`). Validated, not completed. Throws Error.
SceneFile find_scene(const std::string& name, const ReadOptions& options = {});

/// A scene, and what a method prepares of it: made once, drawn as often as one likes, from any
/// thread.
class Renderer {
 public:
  /// `scene` must be complete (`complete_scene`). Cost: O(n log n) over all cores.
  explicit Renderer(Scene scene, Method method = Method::shaft);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// What it was made with.
  const Scene& scene() const;
  Method method() const;
  /// Of hierarchy and shadows, beside the scene.
  std::size_t memory_bytes() const;

  /// Throws Error for options out of range (`check`), and what `progress` throws.
  Picture render(const RenderOptions& options = {}) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

/// Throws Error for what makes no picture: sides of 0 or more than 65536 pixels or more than 2^28
/// in all; d and samples a pixel outside 1 to 65536; a depth outside 1 to 64; more than 1024
/// threads.
void check(const RenderOptions& options);

/// From a file to a file.
struct RenderFileOptions {
  ReadOptions read{};
  SceneOptions scene{};
  Method method = Method::shaft;
  /// The width and height of these count where `keeps_file_size` is false.
  RenderOptions render{};
  bool keeps_file_size = true;  ///< the picture has the size that the file's camera asks for
  float exposure_ev = 0;        ///< of a PNG, in stops
};

/// Draws `scene` (as `find_scene` takes it) to a `.png` or `.exr`, which is there whole or not at
/// all; the name is tried before the work begins. Returns what was drawn. Throws Error.
Picture render_file(const std::string& scene, const std::filesystem::path& picture,
                    const RenderFileOptions& options = {});

}  // namespace penumbra
