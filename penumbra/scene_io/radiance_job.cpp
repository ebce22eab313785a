// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/radiance_job.h"

#include <algorithm>
#include <array>

#include "penumbra/scene_io/text_lines.h"

namespace penumbra {
namespace {

/// Before the `=`, in lower case, since rad takes either.
std::string variable_of(std::string_view line) {
  std::string name(trimmed(line.substr(0, line.find('='))));
  for (char& c : name)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return name;
}

/// rad asks for three letters of a variable's name at least.
bool is_variable(std::string_view given, std::string_view name) {
  return given.size() >= 3 && name.starts_with(given);
}

Vec3d up_axis(std::string_view value, Vec3d otherwise) {
  const bool is_down = value.starts_with('-');
  if (value.starts_with('-') || value.starts_with('+')) value.remove_prefix(1);
  const char axis = value.empty() ? ' ' : value[0];
  const double one = is_down ? -1 : 1;
  if (axis == 'x' || axis == 'X') return {one, 0, 0};
  if (axis == 'y' || axis == 'Y') return {0, one, 0};
  if (axis == 'z' || axis == 'Z') return {0, 0, one};
  return otherwise;
}

}  // namespace

RadianceJob parse_radiance_job(const Source& source) {
  RadianceJob job;
  std::array<std::vector<RadianceJob::Mention>, 3> files;  // materials, illum, scene
  TextLines lines(source.bytes, LineJoints::backslash);
  while (const auto line = lines.next()) {
    const std::size_t equals = line->find('=');
    if (trimmed(*line).starts_with('#') || equals == std::string_view::npos) continue;
    const std::string name = variable_of(*line);
    std::string_view values = line->substr(equals + 1);
    constexpr std::array<std::string_view, 3> lists{"materials", "illum", "scene"};
    for (std::size_t i = 0; i < lists.size(); ++i) {
      if (!is_variable(name, lists[i])) continue;
      for (auto word = next_word(values); !word.empty(); word = next_word(values))
        files[i].push_back({std::string(word), lines.number()});
    }
    if (name == "up") job.up = up_axis(trimmed(values), job.up);
    if (!is_variable(name, "view") || job.view) continue;
    // The view's name, if it has one, stands before its options.
    const std::size_t options = values.find("-v");
    if (options != std::string_view::npos)
      job.view = {std::string(trimmed(values.substr(options))), lines.number()};
  }
  for (std::vector<RadianceJob::Mention>& list : files)
    job.files.insert(job.files.end(), list.begin(), list.end());
  if (files[2].empty() && files[0].empty())
    throw Error({source.path.string(), {}, {}}, "names no scene files",
                "a .rif file has a line such as `scene= room.rad`; give the .rad file itself "
                "where there is only the octree");
  return job;
}

}  // namespace penumbra
