// SPDX-License-Identifier: MIT
#include "tests/scene_io/fuzz/fuzz_format.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <stdexcept>

#include "penumbra/scene_io/read_mtl.h"
#include "penumbra/scene_io/read_points.h"
#include "penumbra/scene_io/source.h"
#include "tests/scene_io/fuzz/mutation.h"

namespace penumbra {
namespace {

/// Messages may quote a file, but not print it.
void check_message(const std::string& message) {
  if (message.empty() || message.size() > 1000)
    throw std::runtime_error("a message is empty or too long");
}

/// Points are no scenes either, and read some at a time.
std::optional<PointFormat> point_format(const std::string& name) {
  if (name == "csv") return PointFormat::csv;
  if (name == "npy") return PointFormat::npy;
  if (name == "points_ply") return PointFormat::ply;
  return {};
}

std::vector<std::string> read_points(const Source& source, PointFormat format) {
  PointReader reader(source.path.string(), source.bytes, format);
  PointBlock block;
  while (reader.next(block, 100))
    if (reader.has_normals() != (block.normals.size() == block.positions.size()))
      throw std::runtime_error("not each point has its normal");
  return {};
}

/// Material files are no scenes: a sphere wears the materials.
std::vector<std::string> read_materials(const Source& source) {
  Scene scene;
  Warnings warnings(source.path.string());
  TextureLoader textures(source, scene, warnings);
  scene.materials = read_mtl(source.bytes, source.path.string(), textures, warnings);
  scene.shapes.spheres.emplace_back();
  validate(scene);
  return warnings.lines();
}

}  // namespace

FuzzFormat load_format(const std::filesystem::path& corpus, const std::string& name) {
  FuzzFormat format{name, corpus / name, {}, {}};
  for (const auto& entry : std::filesystem::directory_iterator(format.folder))
    if (entry.path().extension() == "." + name) format.paths.push_back(entry.path());
  std::sort(format.paths.begin(), format.paths.end());
  for (const std::filesystem::path& path : format.paths) {
    format.samples.push_back(load(path).bytes);
    if (format.samples.back().empty()) throw std::runtime_error(path.string() + " is empty");
  }
  if (format.samples.empty())
    throw std::runtime_error(format.folder.string() + " holds no files ." + name);
  return format;
}

std::vector<std::string> format_names(const std::filesystem::path& corpus) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(corpus))
    if (entry.is_directory()) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string input_of(const FuzzFormat& format, std::uint64_t seed) {
  Dice dice(seed);
  return damaged(format.samples, dice);
}

Outcome read_input(const FuzzFormat& format, std::string bytes) {
  const Source source{format.folder / ("input." + format.name), format.name, std::move(bytes)};
  try {
    const std::optional<PointFormat> points = point_format(format.name);
    const std::vector<std::string> warnings = points ? read_points(source, *points)
                                              : format.name == "mtl"
                                                  ? read_materials(source)
                                                  : read_source(source, {.waters = true}).warnings;
    if (warnings.size() > 100) throw std::runtime_error("too many kinds of warnings");
    for (const std::string& line : warnings) check_message(line);
  } catch (const Error& error) {
    check_message(error.what());
    return Outcome::error;
  }
  return Outcome::scene;
}

}  // namespace penumbra

/// For those who link this file with libFuzzer (-fsanitize=fuzzer): the format's name is in
/// PENUMBRA_FUZZ_FORMAT, and its corpus is a good one to begin with.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const char* name = std::getenv("PENUMBRA_FUZZ_FORMAT");
  static const penumbra::FuzzFormat format = penumbra::load_format(
      PENUMBRA_SOURCE_DIR "/tests/scene_io/corpus", name != nullptr ? name : "nff");
  penumbra::read_input(format, std::string(data, data + size));
  return 0;
}
