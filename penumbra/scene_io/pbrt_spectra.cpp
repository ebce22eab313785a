// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/pbrt_spectra.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "penumbra/scene_io/numbers.h"
#include "penumbra/scene_io/source.h"
#include "penumbra/scene_io/texture_io.h"
#include "penumbra/scene_io/tokens.h"

namespace penumbra {
namespace {

Color clamped(Vec3d rgb, PbrtPlace place) {
  constexpr double most = 1e30;  // squares and sums of a few stay finite
  if (!(max_abs(rgb) <= most))
    throw Error(place, "a colour is beyond 1e30", "give smaller numbers");
  return max(Color(rgb), Color{});
}

Color color_of_pairs(const std::vector<double>& numbers, SpectrumOf of, const Error::Place& place) {
  if (numbers.empty() || numbers.size() % 2 != 0)
    throw Error(place,
                fmt::format("a spectrum of {} numbers, which do not come in pairs", numbers.size()),
                "give a wavelength in nm and a value, in turns");
  std::vector<SpectrumSample> samples;
  for (std::size_t i = 0; i < numbers.size(); i += 2) {
    if (i > 0 && !(numbers[i] > numbers[i - 2]))
      throw Error(place, "a spectrum's wavelengths do not increase");
    if (!(std::abs(numbers[i + 1]) <= 1e30))
      throw Error(place, "a spectrum's value is beyond 1e30");
    samples.push_back({numbers[i], numbers[i + 1]});
  }
  return color_of_spectrum(samples, of);
}

Color color_of_file(const std::filesystem::path& path, SpectrumOf of) {
  const Source source = load(path);
  Tokens tokens(path.string(), source.bytes, Comments::hash);
  std::vector<double> numbers;
  while (!tokens.peek().text.empty())
    numbers.push_back(tokens.number_double("a number of a spectrum"));
  return color_of_pairs(numbers, of, {path.string(), 1, {}});
}

/// "metal-Cu-eta" and the like, glasses, illuminants.
std::optional<Color> color_of_name(std::string_view name) {
  if (name.starts_with("metal-")) {
    const std::size_t dash = name.rfind('-');
    const std::string_view symbol = name.substr(6, std::max<std::size_t>(dash, 6) - 6);
    const auto index = metal_index(symbol);
    if (index && name.ends_with("-eta")) return index->eta;
    if (index && name.ends_with("-k")) return index->k;
  }
  if (name.starts_with("glass-"))
    if (const auto index = glass_index(name.substr(6))) {
      const auto n = static_cast<float>(*index);
      return Color{n, n, n};
    }
  return color_of_illuminant(name);
}

Color color_of_text(const PbrtParameter& parameter, SpectrumOf of,
                    const std::filesystem::path& scene_file) {
  const std::string& name = parameter.texts[0];
  if (const auto color = color_of_name(name)) return *color;
  if (const auto path = find_beside(scene_file, name)) return color_of_file(*path, of);
  throw Error(parameter.place, "there is no spectrum or file " + in_quotes(name),
              "check the name; files are looked for beside the scene's main file");
}

}  // namespace

std::optional<Color> pbrt_color(const PbrtParameter* parameter, SpectrumOf of,
                                const std::filesystem::path& scene_file) {
  if (!parameter) return std::nullopt;
  const PbrtParameter& p = *parameter;
  const auto require = [&](bool holds, const char* hint) {
    if (!holds) throw Error(p.place, "parameter " + in_quotes(p.name) + " is no colour", hint);
  };
  if (p.type == "rgb" || p.type == "color") {
    require(p.numbers.size() == 3, "rgb takes three numbers");
    return clamped({p.numbers[0], p.numbers[1], p.numbers[2]}, p.place);
  }
  if (p.type == "blackbody") {
    require(p.numbers.size() == 1 && p.numbers[0] > 0, "blackbody takes a temperature in kelvin");
    return color_of_blackbody(p.numbers[0]);
  }
  if (p.type == "float" || p.type == "integer") {
    require(p.numbers.size() == 1, "give one number");
    return clamped({p.numbers[0], p.numbers[0], p.numbers[0]}, p.place);
  }
  require(p.type == "spectrum", "give rgb, blackbody or spectrum");
  if (p.texts.empty()) return color_of_pairs(p.numbers, of, p.place);
  require(p.texts.size() == 1 && p.numbers.empty(), "give a name, or wavelengths and values");
  return color_of_text(p, of, scene_file);
}

}  // namespace penumbra
