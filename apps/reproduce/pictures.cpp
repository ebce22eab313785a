// SPDX-License-Identifier: MIT
#include "pictures.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>

#include "../options.h"
#include "class_map.h"
#include "paper.h"
#include "penumbra/scene/complete_scene.h"
#include "penumbra/scene_io/image_formats.h"
#include "penumbra/scene_io/jpeg_io.h"
#include "penumbra/scene_io/write_scene.h"
#include "penumbra/trace/prepare.h"
#include "results.h"

namespace penumbra::reproduce {
namespace {

namespace fs = std::filesystem;

constexpr int jpeg_quality = 90;

/// The share of the (point, light) pairs that are decided without samples.
double decided(const ShadowCounters& n) {
  const auto all = static_cast<double>(n.lit + n.penumbra + n.umbra);
  return all == 0 ? 0 : 100 * static_cast<double>(n.lit + n.umbra) / all;
}

/// A file's own lights may be points; built-in ones are balls, made to look well.
SceneOptions wishes(const Plan& plan, PaperSceneIndex scene) {
  SceneOptions options;
  if (plan.scenes[scene].is_stand_in) options.light_radius = parse_light_radius(plan.size_radius);
  return options;
}

/// One scene's pictures.
class Painter {
 public:
  Painter(const Plan& plan, PaperSceneIndex scene, const Scene& loaded, fs::path folder)
      : plan_(plan),
        folder_(std::move(folder)),
        stem_(fmt::format("figure{}", figure_of(scene))),
        scene_(complete_scene(loaded, wishes(plan, scene))),
        kernel_(scene_.shapes, kernel_options(scene_)) {
    options_.width = options_.height = plan.picture_size;
    options_.shadow_samples = plan.picture_samples;
  }

  View picture() const {
    RenderOptions options = options_;
    options.samples_per_pixel = plan_.picture_spp;
    const Image image = render(scene_, prepared(Method::shaft), options).image;
    const std::string file = stem_ + ".png";
    write_file(folder_ / file, to_png(file, image, 0));
    return {"picture", file, "image/jpeg", encode_jpeg(image, jpeg_quality)};
  }

  /// `share` gets the decided share.
  View map(const char* name, Method method, double& share) const {
    RenderOptions options = options_;
    options.aovs = {Aov::light_class, Aov::depth};
    const Picture picture = render(scene_, prepared(method), options);
    share = decided(picture.counters.shadow);
    const std::string file = fmt::format("{}-{}.png", stem_, name_of(method));
    const std::string bytes = to_png(file, class_map(picture.image), 0);
    write_file(folder_ / file, bytes);
    return {name, file, "image/png", bytes};
  }

 private:
  ShadowScene prepared(Method method) const { return prepare_shadows(scene_, kernel_, method); }

  const Plan& plan_;
  fs::path folder_;
  std::string stem_;
  Scene scene_;
  Kernel kernel_;
  RenderOptions options_;
};

}  // namespace

std::vector<Gallery> draw_pictures(const Plan& plan, Scenes& scenes, const fs::path& folder,
                                   const std::function<void(double)>& progress) {
  std::vector<Gallery> galleries;
  for (const PaperSceneIndex scene : paper_order) {
    progress(static_cast<double>(scene) / static_cast<double>(plan.scenes.size()));
    const Painter painter(plan, scene, scenes.of(plan.scenes[scene].scene), folder);
    double truth = 0, umbra = 0, shaft = 0;
    Gallery gallery{fmt::format("figure{}", figure_of(scene)), {}, {}, {}};
    gallery.views.push_back(painter.picture());
    gallery.views.push_back(painter.map("classes by samples", Method::stochastic, truth));
    gallery.views.push_back(painter.map("proven by umbra (e)", Method::umbra, umbra));
    gallery.views.push_back(painter.map("proven by shaft", Method::shaft, shaft));
    gallery.title = fmt::format("Figure {}: {}", figure_of(scene), title_of(plan, scene));
    gallery.text = fmt::format(
        "{0} × {0} pixels, d = {1}. Of all points and lights, reflections included, {2:.1f} % are "
        "wholly lit or wholly dark by the samples; proven: {3:.1f} % by umbra, {4:.1f} % by shaft.",
        plan.picture_size, plan.picture_samples, truth, umbra, shaft);
    galleries.push_back(std::move(gallery));
  }
  progress(1);
  return galleries;
}

}  // namespace penumbra::reproduce
