// SPDX-License-Identifier: MIT
#include "bake_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

#include "options.h"
#include "output_files.h"

namespace penumbra {
namespace {

bool is_exr(const BakeOutput& output) { return has_extension(output.path, ".exr"); }

/// Letters, digits and what is not ASCII stay.
std::string file_name_of(const std::string& name) {
  constexpr std::size_t longest = 80;
  std::string result;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_first_byte = byte < 0x80 || byte >= 0xC0;
    if (result.size() >= longest && is_first_byte) break;
    result += byte >= 0x80 || std::isalnum(byte) || c == '-' || c == '_' || c == '.' ? c : '_';
  }
  return result;
}

Channel mean_of(const Image& baked, std::size_t lights) {
  Channel mean{"Y", std::vector<float>(std::size_t(baked.width) * baked.height)};
  for (std::size_t i = 0; i < mean.values.size(); ++i) {
    double sum = 0;
    for (std::size_t light = 0; light < lights; ++light)
      sum += double(baked.channels[light].values[i]);
    mean.values[i] = static_cast<float>(sum / double(lights));
  }
  return mean;
}

}  // namespace

std::vector<std::string> files_of(const BakeOutput& output, std::size_t lights) {
  if (is_exr(output) || output.channel == BakeChannel::mean || lights == 1) return {output.path};
  std::vector<std::string> files;
  for (std::size_t i = 0; i < lights; ++i)
    files.push_back(with_suffix(output.path, fmt::format("-light{}", i)));
  return files;
}

std::vector<BakeOutput> outputs_of(const BakeOutput& output,
                                   const std::vector<BakeObject>& objects) {
  std::set<std::string> taken;
  std::vector<BakeOutput> outputs;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    std::string name = file_name_of(objects[i].name);
    if (name.empty()) name = fmt::format("mesh{}", i);
    const std::string wanted = name;
    for (std::size_t number = i; !taken.insert(name).second; ++number)
      name = fmt::format("{}-{}", wanted, number);
    outputs.push_back(output);
    outputs.back().path = with_suffix(output.path, "-" + name);
  }
  return outputs;
}

void write_bake(const BakeOutput& output, Image baked, std::size_t lights) {
  std::vector<Channel> values;
  if (output.channel == BakeChannel::mean)
    values.push_back(mean_of(baked, lights));
  else
    for (std::size_t i = 0; i < lights; ++i) values.push_back(std::move(baked.channels[i]));
  if (!is_exr(output)) {
    const std::vector<std::string> files = files_of(output, lights);
    for (std::size_t i = 0; i < files.size(); ++i)
      write_grey_image(files[i],
                       {baked.width, baked.height, {std::move(values[i])}, baked.metadata},
                       output.png);
    return;
  }
  Image image{baked.width, baked.height, std::move(values), baked.metadata};
  if (output.has_classes)
    for (std::size_t i = 0; i < lights; ++i)
      image.channels.push_back(std::move(baked.channels[lights + i]));
  if (output.has_coverage) image.channels.push_back(std::move(baked.channels.back()));
  write_image(output.path, image);
}

}  // namespace penumbra
