// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/radiance_include.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "penumbra/scene_io/numbers.h"

namespace penumbra {
namespace {

bool is_file(const std::filesystem::path& path) {
  std::error_code problem;
  return std::filesystem::is_regular_file(path, problem);
}

/// The folders of RAYPATH, which are separated by colons.
std::vector<std::filesystem::path> ray_path() {
  const char* variable = std::getenv("RAYPATH");
  std::vector<std::filesystem::path> folders;
  for (std::string_view rest = variable != nullptr ? variable : ""; !rest.empty();) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    if (end > 0) folders.emplace_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return folders;
}

}  // namespace

std::filesystem::path RadianceLibrary::find(const std::string& name,
                                            const Error::Place& place) const {
  const std::filesystem::path path(name), user(place.file);
  if (name.find('\0') == std::string::npos && !name.empty()) {
    if (path.is_absolute() && is_file(path)) return path;
    const std::filesystem::path folder = scene_.parent_path();
    std::vector<std::filesystem::path> folders{user.parent_path(), folder, folder / "..", {}};
    for (std::filesystem::path& other : ray_path()) folders.push_back(std::move(other));
    const std::filesystem::path wanted = path.is_absolute() ? path.filename() : path;
    for (const std::filesystem::path& place_to_look : folders)
      if (is_file(place_to_look / wanted)) return (place_to_look / wanted).lexically_normal();
  }
  throw Error(place, fmt::format("the file {} is missing", in_quotes(name)),
              "put it beside this file or beside the scene, or its folder into the environment "
              "variable RAYPATH");
}

const RadianceFile& RadianceLibrary::open(const std::string& name, const Error::Place& place) {
  const std::filesystem::path path = find(name, place);
  std::error_code ignored;
  std::unique_ptr<RadianceFile>& file = files_[std::filesystem::weakly_canonical(path, ignored)];
  if (!file) file = std::make_unique<RadianceFile>(parse_radiance(load(path)));
  return *file;
}

std::string RadianceLibrary::text(const std::string& name, const Error::Place& place) const {
  return load(find(name, place)).bytes;
}

const RadianceFile& RadianceLibrary::keep(RadianceFile file) {
  made_.push_back(std::make_unique<RadianceFile>(std::move(file)));
  return *made_.back();
}

}  // namespace penumbra
