// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/pbrt_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "penumbra/scene_io/numbers.h"

namespace penumbra {
namespace {

/// x0, x1, y0, y1.
struct Rectangle {
  double x0 = 0, x1 = 1, y0 = 0, y1 = 1;
};

struct Film {
  double width = 1280, height = 720;
  Rectangle crop;  ///< part of it that is drawn, in pixels
};

double resolution(const PbrtParams& params, const char* name, double otherwise) {
  const double size = params.number(name, otherwise);
  if (!(size >= 1 && size <= 65536 && size == std::floor(size)))
    throw Error(params.place(), fmt::format("{} {} makes no picture", name, size),
                "give whole numbers from 1 to 65536");
  return size;
}

std::optional<Rectangle> rectangle(const PbrtParams& params, const char* name) {
  const std::vector<double> n = params.numbers(name);
  if (n.empty()) return std::nullopt;
  if (n.size() != 4 || !(n[0] < n[1]) || !(n[2] < n[3]))
    throw Error(params.place(), fmt::format("{} encloses nothing", in_quotes(name)),
                "give x0 x1 y0 y1 with x0 < x1 and y0 < y1");
  return Rectangle{n[0], n[1], n[2], n[3]};
}

Film read_film(const PbrtScene& pbrt) {
  Film film;
  if (pbrt.film) {
    const PbrtParams& params = pbrt.film->params;
    film.width = resolution(params, "xresolution", film.width);
    film.height = resolution(params, "yresolution", film.height);
  }
  film.crop = {0, film.width, 0, film.height};
  if (!pbrt.film) return film;
  const auto pixels = rectangle(pbrt.film->params, "pixelbounds"),
             share = rectangle(pbrt.film->params, "cropwindow");
  Rectangle crop = pixels.value_or(film.crop);
  if (share)
    crop = {std::ceil(film.width * share->x0), std::ceil(film.width * share->x1),
            std::ceil(film.height * share->y0), std::ceil(film.height * share->y1)};
  crop = {std::max(crop.x0, 0.0), std::min(crop.x1, film.width), std::max(crop.y0, 0.0),
          std::min(crop.y1, film.height)};
  if (!(crop.x0 < crop.x1 && crop.y0 < crop.y1))
    throw Error(pbrt.film->params.place(), "no pixel is left of the picture",
                "widen cropwindow or pixelbounds");
  film.crop = crop;
  return film;
}

/// What the film covers of the plane at distance 1 of a field of view of 90 degrees.
Rectangle screen_of(const PbrtParams& params, const Film& film) {
  if (const auto screen = rectangle(params, "screenwindow")) return *screen;
  const double aspect = params.number("frameaspectratio", film.width / film.height);
  if (!(aspect > 0)) throw Error(params.place(), "a frameaspectratio that is not above 0");
  if (aspect > 1) return {-aspect, aspect, -1, 1};
  return {-1, 1, -1 / aspect, 1 / aspect};
}

double field_of_view(const PbrtParams& params) {
  const double fov =
      params.has("halffov") ? 2 * params.number("halffov", 45) : params.number("fov", 90);
  if (!(fov > 0 && fov < 180))
    throw Error(params.place(), fmt::format("a field of view of {} degrees", fov),
                "give one between 0 and 180");
  return fov;
}

/// Whether the kind of camera is ours; what is not becomes a perspective one.
bool is_parallel(PbrtScene& pbrt) {
  const PbrtDefinition& camera = *pbrt.camera;
  if (camera.kind == "orthographic") return true;
  if (camera.kind == "perspective") return false;
  if (camera.kind != "spherical" && camera.kind != "realistic" && camera.kind != "environment")
    throw Error(camera.params.place(), "unknown camera " + in_quotes(camera.kind),
                "pbrt-v4 has perspective, orthographic, spherical and realistic");
  pbrt.warnings.add(fmt::format("a {} camera is drawn in perspective", camera.kind),
                    camera.params.place());
  return false;
}

void warn_of_camera(PbrtScene& pbrt) {
  const PbrtParams& params = pbrt.camera->params;
  if (params.number("lensradius", 0) > 0 || params.has("aperturediameter"))
    pbrt.warnings.add("a lens (lensradius) is drawn as a point: everything is sharp",
                      params.place());
  for (const char* harmless : {"focaldistance", "shutteropen", "shutterclose", "focusdistance",
                               "lensfile", "mapping", "aperture"})
    params.has(harmless);
  warn_unread(pbrt, "Camera", *pbrt.camera);
}

/// The part of the whole that the pixels show, by the share of the film's pixels.
ImageWindow window_of(const Film& film, const Rectangle& screen, bool is_mirrored) {
  const double height = screen.y1 - screen.y0, width = screen.x1 - screen.x0;
  const double whole_width = height * film.width / film.height;
  // Of the whole picture, which is centred on the axis and as high as the screen.
  const auto across = [&](double pixel) {
    const double x = screen.x0 + width * pixel / film.width;
    return 0.5 + (is_mirrored ? -x : x) / whole_width;
  };
  const auto down = [&](double pixel) {
    return 0.5 - (screen.y1 - height * pixel / film.height) / height;
  };
  return {across(film.crop.x0), down(film.crop.y0), across(film.crop.x1), down(film.crop.y1)};
}

/// pbrt names no axis; where the camera stands upright says it.
Vec3d nearest_axis(Vec3d v) {
  int longest = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (std::abs(v[axis]) > std::abs(v[longest])) longest = axis;
  Vec3d up;
  up[longest] = v[longest] < 0 ? -1 : 1;
  return up;
}

}  // namespace

void finish_pbrt_camera(PbrtScene& pbrt) {
  const Film film = read_film(pbrt);
  if (!pbrt.camera) return;
  const PbrtParams& params = pbrt.camera->params;
  const auto found = inverse(pbrt.camera_from_world);
  if (!found)
    throw Error(params.place(), "the camera's transformation cannot be turned round",
                "check the directives before Camera");
  const Transform world = *found;
  const bool parallel = is_parallel(pbrt);
  const Rectangle screen = screen_of(params, film);
  const double height = screen.y1 - screen.y0;
  const Vec3d forward = normalize(world.z_axis);
  // Heights beside depths, where the camera's frame is stretched.
  const double stretch = length(world.y_axis) / (parallel ? 1 : length(world.z_axis));
  if (std::abs(length(world.x_axis) - length(world.y_axis)) > 1e-3 * length(world.y_axis) ||
      std::abs((screen.x1 - screen.x0) / height * film.height / film.width - 1) > 1e-2)
    pbrt.warnings.add("pixels that are not square are drawn square", params.place());

  Camera camera;
  camera.from = world.offset;
  camera.at = world.offset + forward * length(world.z_axis);
  camera.up = normalize(world.y_axis);
  if (parallel)
    camera.parallel_height = height * stretch;
  else
    camera.fov_deg =
        2 *
        std::atan(std::tan(field_of_view(params) * std::numbers::pi / 360) * height / 2 * stretch) *
        180 / std::numbers::pi;
  const bool is_mirrored = dot(cross(forward, camera.up), world.x_axis) < 0;
  camera.window = window_of(film, screen, is_mirrored);
  camera.width = static_cast<std::uint32_t>(film.crop.x1 - film.crop.x0);
  camera.height = static_cast<std::uint32_t>(film.crop.y1 - film.crop.y0);
  warn_of_camera(pbrt);
  pbrt.scene.camera = camera;
  pbrt.scene.up = nearest_axis(camera.up);
}

}  // namespace penumbra
