// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <CLI/App.hpp>

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "commands.h"
#include "image_difference.h"
#include "options.h"
#include "penumbra/scene/error.h"
#include "penumbra/scene_io/image_io.h"
#include "usage_error.h"

namespace penumbra {
namespace {

struct CompareOptions {
  std::string a, b;
  std::optional<double> tolerance;  ///< none: bit for bit
  bool json = false;
};

/// The first of the colours that is not there; nothing where all are.
std::string missing_color(const Image& image) {
  for (const char* name : {"R", "G", "B"})
    if (!find_channel(image, name)) return name;
  return {};
}

/// The colours; of two files without, such as bakes, what both have.
std::vector<std::string> channels_to_compare(const CompareOptions& options, const Image& a,
                                             const Image& b) {
  const std::string of_a = missing_color(a), of_b = missing_color(b);
  if (of_a.empty() && of_b.empty()) return {"R", "G", "B"};
  if (of_a.empty() || of_b.empty())
    throw Error({of_b.empty() ? options.a : options.b, {}, {}},
                fmt::format("has no channel {}, and {} has colours", of_a + of_b,
                            of_b.empty() ? options.b : options.a),
                "compare pictures with pictures, bakes with bakes");
  std::vector<std::string> shared;
  for (const Channel& channel : a.channels)
    if (find_channel(b, channel.name)) shared.push_back(channel.name);
  if (shared.empty())
    throw Error({options.b, {}, {}}, fmt::format("has no channel that {} has", options.a),
                "compare files that hold the same");
  return shared;
}

nlohmann::json to_json(const CompareOptions& options, const Image& a, const Image& b,
                       const std::vector<std::string>& channels,
                       const std::optional<ImageDifference>& found, bool is_equal) {
  nlohmann::json json = {{"a", options.a},
                         {"b", options.b},
                         {"size", {a.width, a.height}},
                         {"size_b", {b.width, b.height}},
                         {"channels", channels},
                         {"equal", is_equal}};
  // JSON has no infinity: nlohmann-json writes null for it.
  if (found) {
    json["rmse"] = found->rmse;
    json["psnr"] = found->psnr;
    json["max_difference"] = found->largest;
    json["differing_pixels"] = found->pixels;
  } else {
    for (const char* key : {"rmse", "psnr", "max_difference", "differing_pixels"})
      json[key] = nullptr;
  }
  if (options.tolerance) json["tolerance"] = *options.tolerance;
  return json;
}

void print_text(const CompareOptions& options, const Image& a, const Image& b,
                const std::vector<std::string>& channels,
                const std::optional<ImageDifference>& found, bool is_equal) {
  if (!found) {
    fmt::print("differ: {}x{} pixels and {}x{} pixels\n", a.width, a.height, b.width, b.height);
    return;
  }
  const char* how = options.tolerance ? "equal within the tolerance" : "equal bit for bit";
  fmt::print("{}\n", is_equal ? how : "differ");
  fmt::print("size              {}x{}\n", a.width, a.height);
  fmt::print("channels          {}\n", fmt::join(channels, ", "));
  fmt::print("rmse              {:.6g}\n", found->rmse);
  fmt::print("psnr              {:.2f} dB\n", found->psnr);
  fmt::print("max difference    {:.6g}\n", found->largest);
  fmt::print("differing pixels  {} of {}\n", found->pixels, std::uint64_t{a.width} * a.height);
}

int run(const CompareOptions& options) {
  const Image a = read_image(options.a), b = read_image(options.b);
  const std::vector<std::string> channels = channels_to_compare(options, a, b);
  std::optional<ImageDifference> found;
  if (a.width == b.width && a.height == b.height)
    found = difference(a, b, options.tolerance, channels);
  const bool is_equal = found && found->pixels == 0;
  if (options.json)
    fmt::print("{}\n", to_json(options, a, b, channels, found, is_equal).dump(2));
  else
    print_text(options, a, b, channels, found, is_equal);
  return is_equal ? 0 : 1;
}

}  // namespace

Command add_compare(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("compare", "Compare the colours of two pictures, or two bakes");
  const auto options = std::make_shared<CompareOptions>();
  app->add_option("A", options->a, "A picture, .png or .exr")->required();
  app->add_option("B", options->b, "The other one")->required();
  app->add_flag("--json", options->json, "Print JSON");
  add_parsed(*app, "--tolerance", "T",
             "Colours that differ by no more count as equal (default: equal bit for bit)",
             [options](const std::string& text) {
               options->tolerance = parse_number(text, 0, std::numeric_limits<float>::max());
             });
  app->footer(
      "What counts are the colours, R, G and B, whatever other channels there are. Of two .exr "
      "files\n"
      "without colours, such as those of `penumbra bake`, the channels that both have, by name.\n"
      "Exit code: 0 equal, 1 different, 2 one of them cannot be read.\n"
      "PNG colours are compared as stored, codes / 255.\n\n"
      "Examples:\n"
      "  penumbra compare before.exr after.exr --tolerance 1e-6\n"
      "  penumbra compare lightmap.exr other_lightmap.exr\n");
  return {app, [options] { return run(*options); }, 2};
}

}  // namespace penumbra
