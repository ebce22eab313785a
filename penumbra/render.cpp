// SPDX-License-Identifier: MIT
#include "penumbra/render.h"

#include <cstdint>
#include <system_error>
#include <utility>

#include "penumbra/kernel/kernel.h"
#include "penumbra/scene/gallery.h"
#include "penumbra/trace/prepare.h"
#include "penumbra/trace/render.h"

namespace penumbra {
namespace {

void check_range(const char* name, std::uint64_t value, std::uint64_t least, std::uint64_t most) {
  if (value >= least && value <= most) return;
  throw Error({}, std::string(name) + " is " + std::to_string(value),
              "give " + std::to_string(least) + " to " + std::to_string(most));
}

}  // namespace

Scene load_built_in_scene(const std::string& name) {
  if (std::optional<Scene> scene = gallery_scene(name)) return *std::move(scene);
  std::string names;
  for (const GalleryEntry& entry : gallery_help())
    names += (names.empty() ? "" : ", ") + entry.name;
  throw Error({name, {}, {}}, "no such file, and no built-in scene of that name",
              "built-in are " + names);
}

SceneFile find_scene(const std::string& name, const ReadOptions& options) {
  std::error_code ignored;  // read_scene says it better
  const std::filesystem::file_type type = std::filesystem::status(name, ignored).type();
  if (type == std::filesystem::file_type::not_found) return {load_built_in_scene(name), {}};
  if (type == std::filesystem::file_type::directory)
    if (std::optional<Scene> scene = gallery_scene(name)) return {*std::move(scene), {}};
  return read_scene(name, options);
}

void check(const RenderOptions& options) {
  constexpr std::uint64_t largest_side = 65536, most_pixels = std::uint64_t{1} << 28;
  check_range("the picture's width", options.width, 1, largest_side);
  check_range("the picture's height", options.height, 1, largest_side);
  check_range("the number of pixels", std::uint64_t(options.width) * options.height, 1,
              most_pixels);
  check_range("the number of shadow samples", options.shadow_samples, 1, 65536);
  check_range("the number of samples a pixel", options.samples_per_pixel, 1, 65536);
  check_range("the depth", options.depth, 1, 64);
  check_range("the edge of tiles", options.tile, 1, 65536);
  check_range("the number of threads", options.threads, 0, 1024);
}

// Kernel and shadows refer to what stands before them, so none of it moves.
struct Renderer::Data {
  Data(Scene complete, Method method)
      : scene(std::move(complete)),
        kernel(scene.shapes, kernel_options(scene)),
        shadows(prepare_shadows(scene, kernel, method)) {}

  Scene scene;
  Kernel kernel;
  ShadowScene shadows;
};

Renderer::Renderer(Scene scene, Method method) {
  if (!scene.camera)
    throw Error({scene.name, {}, {}}, "the scene has no camera",
                "complete it first (complete_scene)");
  data_ = std::make_unique<Data>(std::move(scene), method);
}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

const Scene& Renderer::scene() const { return data_->scene; }
Method Renderer::method() const { return data_->shadows.method; }
std::size_t Renderer::memory_bytes() const {
  return data_->kernel.memory_bytes() + data_->shadows.memory_bytes();
}

Picture Renderer::render(const RenderOptions& options) const {
  check(options);
  return penumbra::render(data_->scene, data_->shadows, options);
}

Picture render_file(const std::string& scene, const std::filesystem::path& picture,
                    const RenderFileOptions& options) {
  check_image_path(picture);
  const Renderer renderer(complete_scene(find_scene(scene, options.read).scene, options.scene),
                          options.method);
  RenderOptions render = options.render;
  if (options.keeps_file_size) {
    render.width = renderer.scene().camera->width;
    render.height = renderer.scene().camera->height;
  }
  Picture drawn = renderer.render(render);
  write_image(picture, drawn.image, options.exposure_ev);
  return drawn;
}

}  // namespace penumbra
