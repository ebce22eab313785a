// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <CLI/App.hpp>

#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "commands.h"
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

struct Difference {
  double rmse = 0, psnr = std::numeric_limits<double>::infinity();  ///< peak 1, in dB
  double largest = 0;
  std::uint64_t pixels = 0;  ///< with a colour that differs
};

/// Equal bits, or NaN twice.
bool is_same(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b) ||
         (std::isnan(a) && std::isnan(b));
}

/// |a - b|; infinite where only one is NaN.
double distance(float a, float b) {
  if (a == b || is_same(a, b)) return 0;
  const double difference = std::abs(double{a} - double{b});
  return std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
}

/// Pictures of the same size with all of R, G, B.
Difference difference(const Image& a, const Image& b, std::optional<double> tolerance) {
  const std::array names = {"R", "G", "B"};
  std::array<const Channel*, 3> of_a{}, of_b{};
  for (std::size_t c = 0; c < names.size(); ++c) {
    of_a[c] = find_channel(a, names[c]);
    of_b[c] = find_channel(b, names[c]);
  }
  Difference result;
  double squares = 0;
  const std::size_t count = std::size_t{a.width} * a.height;
  for (std::size_t i = 0; i < count; ++i) {
    bool differs = false;
    for (std::size_t c = 0; c < names.size(); ++c) {
      const float x = of_a[c]->values[i], y = of_b[c]->values[i];
      const double gap = distance(x, y);
      squares += gap * gap;
      result.largest = std::max(result.largest, gap);
      differs |= tolerance ? gap > *tolerance : !is_same(x, y);
    }
    result.pixels += differs;
  }
  const double mean = squares / (3.0 * static_cast<double>(count));
  result.rmse = std::sqrt(mean);
  if (mean > 0) result.psnr = -10 * std::log10(mean);
  return result;
}

Image read_colors(const std::string& path) {
  Image image = read_image(path);
  for (const char* name : {"R", "G", "B"})
    if (!find_channel(image, name))
      throw Error({path, {}, {}}, fmt::format("has no channel {}", name),
                  "only pictures with R, G and B can be compared");
  return image;
}

nlohmann::json to_json(const CompareOptions& options, const Image& a, const Image& b,
                       const std::optional<Difference>& found, bool is_equal) {
  nlohmann::json json = {{"a", options.a},
                         {"b", options.b},
                         {"size", {a.width, a.height}},
                         {"size_b", {b.width, b.height}},
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
                const std::optional<Difference>& found, bool is_equal) {
  if (!found) {
    fmt::print("differ: {}x{} pixels and {}x{} pixels\n", a.width, a.height, b.width, b.height);
    return;
  }
  const char* how = options.tolerance ? "equal within the tolerance" : "equal bit for bit";
  fmt::print("{}\n", is_equal ? how : "differ");
  fmt::print("size              {}x{}\n", a.width, a.height);
  fmt::print("rmse              {:.6g}\n", found->rmse);
  fmt::print("psnr              {:.2f} dB\n", found->psnr);
  fmt::print("max difference    {:.6g}\n", found->largest);
  fmt::print("differing pixels  {} of {}\n", found->pixels, std::uint64_t{a.width} * a.height);
}

int run(const CompareOptions& options) {
  const Image a = read_colors(options.a), b = read_colors(options.b);
  std::optional<Difference> found;
  if (a.width == b.width && a.height == b.height) found = difference(a, b, options.tolerance);
  const bool is_equal = found && found->pixels == 0;
  if (options.json)
    fmt::print("{}\n", to_json(options, a, b, found, is_equal).dump(2));
  else
    print_text(options, a, b, found, is_equal);
  return is_equal ? 0 : 1;
}

}  // namespace

Command add_compare(CLI::App& program) {
  CLI::App* app = program.add_subcommand("compare", "Compare the colours of two pictures");
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
      "Exit code: 0 equal, 1 different, 2 one of them cannot be read.\n"
      "PNG colours are compared as stored, codes / 255.\n\n"
      "Example:\n"
      "  penumbra compare before.exr after.exr --tolerance 1e-6\n");
  return {app, [options] { return run(*options); }, 2};
}

}  // namespace penumbra
