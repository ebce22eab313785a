// SPDX-License-Identifier: MIT
// Radiance: scene files (.rad), rad's control files (.rif), and a view file of the same name.
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "penumbra/scene_io/radiance_builder.h"
#include "penumbra/scene_io/radiance_file.h"
#include "penumbra/scene_io/radiance_job.h"
#include "penumbra/scene_io/radiance_view.h"
#include "penumbra/scene_io/source.h"

namespace penumbra {
namespace {

void take_view(Scene& scene, const RadianceView& view, Warnings& warnings) {
  if (!view.warning.empty()) warnings.add(view.warning);
  scene.camera = view.camera;
}

/// room.rad's view is likely in room.vf.
void take_view_beside(Scene& scene, const std::filesystem::path& path, Warnings& warnings) {
  std::filesystem::path file = path;
  if (file.extension() == ".gz") file.replace_extension();
  file.replace_extension(".vf");
  std::error_code problem;
  if (!std::filesystem::is_regular_file(file, problem)) return;
  warnings.add(fmt::format("its view is that of {} beside it", file.filename().string()));
  take_view(scene, read_radiance_view(file), warnings);
}

void read_job(const Source& source, RadianceBuilder& builder, Scene& scene, Warnings& warnings) {
  const RadianceJob job = parse_radiance_job(source);
  scene.up = job.up;
  const std::string name = source.path.string();
  for (const RadianceJob::Mention& file : job.files)
    builder.read_main(builder.library().open(file.text, {name, file.line, {}}));
  if (!job.view) return;
  try {
    take_view(scene, parse_radiance_view(job.view->text, source.path.parent_path()), warnings);
  } catch (const Error& error) {
    if (!error.place.file.empty()) throw;
    throw Error({name, job.view->line, {}}, error.problem, error.hint);
  }
}

}  // namespace

Scene read_radiance(const Source& source, Warnings& warnings) {
  Scene scene;
  scene.name = source.path.string();
  RadianceBuilder builder(scene, warnings, source.path);
  if (source.extension == "rif")
    read_job(source, builder, scene, warnings);
  else
    builder.read_main(builder.library().keep(parse_radiance(source)));
  builder.finish();
  if (!scene.camera) take_view_beside(scene, source.path, warnings);
  return scene;
}

}  // namespace penumbra
