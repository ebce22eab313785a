// SPDX-License-Identifier: MIT
#include "options.h"

#include <fmt/format.h>

#include <CLI/App.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <span>
#include <utility>

#include "penumbra/scene/error.h"
#include "penumbra/scene_io/light_spec.h"
#include "usage_error.h"

namespace penumbra {
namespace {

constexpr double largest_coordinate = 1e15;  // what `validate` takes

template <typename Number>
std::optional<Number> number(std::string_view text) {
  Number value{};
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return value;
}

/// The `Count` parts between commas; the error says what was `expected`.
template <std::size_t Count>
std::array<std::string_view, Count> parts(std::string_view text, const char* expected) {
  std::array<std::string_view, Count> result;
  for (std::size_t i = 0; i < Count; ++i) {
    const std::size_t comma = text.find(',');
    if ((comma == text.npos) != (i + 1 == Count)) throw UsageError(expected);
    result[i] = text.substr(0, comma);
    if (comma != text.npos) text.remove_prefix(comma + 1);
  }
  return result;
}

template <typename Value>
struct Choice {
  std::string_view name;
  Value value;
};

template <typename Value>
Value choose(std::string_view text, std::span<const Choice<Value>> choices) {
  std::vector<std::string> names;
  for (const Choice<Value>& choice : choices) {
    if (choice.name == text) return choice.value;
    names.emplace_back(choice.name);
  }
  throw UsageError(fmt::format("expected one of {}", fmt::join(names, ", ")), names);
}

constexpr std::array methods = {
    Choice<Method>{"hard", Method::hard},     Choice<Method>{"stochastic", Method::stochastic},
    Choice<Method>{"offset", Method::offset}, Choice<Method>{"reduced", Method::reduced},
    Choice<Method>{"umbra", Method::umbra},   Choice<Method>{"shaft", Method::shaft}};

}  // namespace

double parse_number(std::string_view text, double least, double most) {
  const std::optional<double> value = number<double>(text);
  if (!value || !(*value >= least && *value <= most))  // NaN is in no range
    throw UsageError(fmt::format("expected a number from {:g} to {:g}", least, most));
  return *value;
}

std::uint64_t parse_count(std::string_view text, std::uint64_t least, std::uint64_t most) {
  const std::optional<std::uint64_t> value = number<std::uint64_t>(text);
  if (!value || *value < least || *value > most)
    throw UsageError(fmt::format("expected a whole number from {} to {}", least, most));
  return *value;
}

PixelSize parse_size(std::string_view text) {
  constexpr std::uint64_t largest_side = 65536, most_pixels = std::uint64_t{1} << 28;
  const std::size_t cross = text.find('x');
  const auto width = number<std::uint64_t>(text.substr(0, cross));
  const auto height =
      cross == text.npos ? std::nullopt : number<std::uint64_t>(text.substr(cross + 1));
  if (!width || !height) throw UsageError("expected WIDTHxHEIGHT, such as 640x480");
  if (*width == 0 || *height == 0) throw UsageError("a picture has at least one pixel each way");
  if (*width > largest_side || *height > largest_side || *width * *height > most_pixels)
    throw UsageError(
        fmt::format("at most {} pixels a side and {} in all", largest_side, most_pixels));
  return {static_cast<std::uint32_t>(*width), static_cast<std::uint32_t>(*height)};
}

PixelPosition parse_pixel(std::string_view text) {
  const auto [x, y] = parts<2>(text, "expected x,y, such as 256,256");
  return {static_cast<std::uint32_t>(parse_count(x, 0, 65535)),
          static_cast<std::uint32_t>(parse_count(y, 0, 65535))};
}

Vec3d parse_vector(std::string_view text) {
  const auto [x, y, z] = parts<3>(text, "expected x,y,z, such as 0,-4,1.5");
  const auto coordinate = [](std::string_view part) {
    return parse_number(part, -largest_coordinate, largest_coordinate);
  };
  return {coordinate(x), coordinate(y), coordinate(z)};
}

Color parse_color(std::string_view text) {
  const auto [r, g, b] = parts<3>(text, "expected r,g,b, such as 0.1,0.2,0.4");
  const auto amount = [](std::string_view part) {
    return static_cast<float>(parse_number(part, 0, 1e6));
  };
  return {amount(r), amount(g), amount(b)};
}

LightRadius parse_light_radius(std::string_view text) {
  const bool is_percent = text.ends_with('%');
  if (is_percent) text.remove_suffix(1);
  const std::optional<double> value = number<double>(text);
  const float radius = static_cast<float>(value.value_or(0));
  if (!value || !(radius > 0 && *value <= largest_coordinate))
    throw UsageError(
        "expected a radius above 0, in scene units or as N% of the objects' largest extent");
  return {radius, is_percent};
}

std::variant<GroundChoice, double> parse_ground(std::string_view text) {
  if (text == "auto") return GroundChoice::automatic;
  if (text == "none") return GroundChoice::none;
  const std::optional<double> height = number<double>(text);
  if (!height || !(std::abs(*height) <= largest_coordinate))
    throw UsageError("expected auto, none or a height", {"auto", "none"});
  return *height;
}

MoleculeStyle parse_style(std::string_view text) {
  static constexpr std::array styles = {
      Choice<MoleculeStyle>{"ball-and-stick", MoleculeStyle::ball_and_stick},
      Choice<MoleculeStyle>{"space-filling", MoleculeStyle::space_filling}};
  return choose<MoleculeStyle>(text, styles);
}

std::vector<std::string> parse_list(std::string_view text) {
  std::vector<std::string> list;
  for (;;) {
    const std::size_t comma = text.find(',');
    list.emplace_back(text.substr(0, comma));
    if (comma == text.npos) return list;
    text.remove_prefix(comma + 1);
  }
}

Shell parse_shell(std::string_view text) {
  static constexpr std::array shells = {Choice<Shell>{"bash", Shell::bash},
                                        Choice<Shell>{"zsh", Shell::zsh},
                                        Choice<Shell>{"fish", Shell::fish}};
  return choose<Shell>(text, shells);
}

Method parse_method(std::string_view text) { return choose<Method>(text, methods); }

Method parse_asking_method(std::string_view text) {
  static constexpr std::array of_points = {Choice<Method>{"shaft", Method::shaft},
                                           Choice<Method>{"stochastic", Method::stochastic}};
  return choose<Method>(text, of_points);
}

std::vector<Method> all_methods() {
  std::vector<Method> all;
  for (const Choice<Method>& choice : methods) all.push_back(choice.value);
  return all;
}

std::string_view name_of(Method method) {
  for (const Choice<Method>& choice : methods)
    if (choice.value == method) return choice.name;
  return {};
}

EmbreeSpheres parse_embree_spheres(std::string_view text) {
  static constexpr std::array kinds = {Choice<EmbreeSpheres>{"native", EmbreeSpheres::native},
                                       Choice<EmbreeSpheres>{"user", EmbreeSpheres::user}};
  return choose<EmbreeSpheres>(text, kinds);
}

std::vector<Aov> parse_aovs(std::string_view text) {
  static constexpr std::array layers = {
      Choice<Aov>{"class", Aov::light_class}, Choice<Aov>{"visibility", Aov::visibility},
      Choice<Aov>{"depth", Aov::depth}, Choice<Aov>{"normal", Aov::normal},
      Choice<Aov>{"samples", Aov::samples}};
  std::vector<Aov> aovs;
  for (const std::string& name : parse_list(text)) {
    const Aov aov = choose<Aov>(name, layers);
    if (std::find(aovs.begin(), aovs.end(), aov) == aovs.end()) aovs.push_back(aov);
  }
  return aovs;
}

UvChoice parse_uv_set(std::string_view text) {
  static constexpr std::array sets = {Choice<UvChoice>{"auto", UvChoice::automatic},
                                      Choice<UvChoice>{"1", UvChoice::first},
                                      Choice<UvChoice>{"2", UvChoice::second}};
  return choose<UvChoice>(text, sets);
}

BakeValue parse_bake_value(std::string_view text) {
  static constexpr std::array weights = {Choice<BakeValue>{"none", BakeValue::fraction},
                                         Choice<BakeValue>{"cosine", BakeValue::cosine_weighted}};
  return choose<BakeValue>(text, weights);
}

int parse_bits(std::string_view text) {
  static constexpr std::array bits = {Choice<int>{"8", 8}, Choice<int>{"16", 16}};
  return choose<int>(text, bits);
}

BakeChannel parse_bake_channel(std::string_view text) {
  static constexpr std::array channels = {Choice<BakeChannel>{"per-light", BakeChannel::per_light},
                                          Choice<BakeChannel>{"mean", BakeChannel::mean}};
  return choose<BakeChannel>(text, channels);
}

void parse_bake_layers(std::string_view text, BakeOutput& output) {
  using Layer = bool BakeOutput::*;
  static constexpr std::array layers = {Choice<Layer>{"class", &BakeOutput::has_classes},
                                        Choice<Layer>{"coverage", &BakeOutput::has_coverage}};
  for (const std::string& name : parse_list(text)) output.*choose<Layer>(name, layers) = true;
}

std::vector<Light> parse_lights(const std::vector<std::string>& words) {
  // One quoted argument may hold all words of a light.
  std::vector<std::string> all;
  for (const std::string& word : words)
    for (std::string& part : split_words(word)) all.push_back(std::move(part));
  std::vector<Light> lights;
  for (std::size_t begin = 0; begin < all.size();) {
    std::size_t end = begin + 1;
    while (end < all.size() && (number<double>(all[end]) || all[end] == "beam")) ++end;
    try {
      lights.push_back(parse_light(std::span(all).subspan(begin, end - begin)));
    } catch (const Error& error) {
      throw UsageError(std::string("--light: ") + error.what());
    }
    begin = end;
  }
  return lights;
}

bool has_extension(std::string_view name, std::string_view extension) {
  std::string found = std::filesystem::path(name).extension().string();
  std::transform(found.begin(), found.end(), found.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return found == extension;
}

std::string parse_output(std::string_view text,
                         std::initializer_list<std::string_view> extensions) {
  std::string known;
  for (const std::string_view extension : extensions) {
    if (has_extension(text, extension)) return std::string(text);
    known += (known.empty() ? "" : " or ") + std::string(extension);
  }
  throw UsageError("expected a name that ends in " + known);
}

PointFormat parse_point_format(std::string_view text) {
  static constexpr std::array formats = {Choice<PointFormat>{"csv", PointFormat::csv},
                                         Choice<PointFormat>{"ply", PointFormat::ply},
                                         Choice<PointFormat>{"npy", PointFormat::npy},
                                         Choice<PointFormat>{"float", PointFormat::float32},
                                         Choice<PointFormat>{"double", PointFormat::float64}};
  return choose<PointFormat>(text, formats);
}

AnswerFormat parse_answer_format(std::string_view text) {
  static constexpr std::array formats = {Choice<AnswerFormat>{"csv", AnswerFormat::csv},
                                         Choice<AnswerFormat>{"ascii", AnswerFormat::ascii},
                                         Choice<AnswerFormat>{"npy", AnswerFormat::npy},
                                         Choice<AnswerFormat>{"ply", AnswerFormat::ply},
                                         Choice<AnswerFormat>{"float", AnswerFormat::float32},
                                         Choice<AnswerFormat>{"double", AnswerFormat::float64}};
  return choose<AnswerFormat>(text, formats);
}

void check_files_differ(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty() || a == "-" || b == "-") return;
  // Names of pipes (/dev/fd/63) lead nowhere, and so tell nothing.
  std::error_code error_a, error_b, ignored;
  const auto path_a = std::filesystem::weakly_canonical(a, error_a),
             path_b = std::filesystem::weakly_canonical(b, error_b);
  const bool is_same = !error_a && !error_b && !path_a.empty() && path_a == path_b;
  if (is_same || std::filesystem::equivalent(a, b, ignored))
    throw UsageError(
        fmt::format("{} and {} are the same file; give the output another name", a, b));
}

CLI::Option* add_parsed(CLI::App& command, const std::string& names, const std::string& value,
                        const std::string& help,
                        const std::function<void(const std::string&)>& parse) {
  const auto parse_named = [names, parse](const std::string& text) {
    try {
      parse(text);
    } catch (const UsageError& error) {
      throw UsageError(fmt::format("{} {}: {}", names, text, error.what()), error.choices);
    }
  };
  return command.add_option_function<std::string>(names, parse_named, help)->type_name(value);
}

void add_read_options(CLI::App& command, ReadOptions& options) {
  add_parsed(command, "--style", "STYLE", "Molecules: ball-and-stick (default) or space-filling",
             [&options](const std::string& text) { options.style = parse_style(text); })
      ->group("Molecules");
  command.add_flag("--waters", options.waters, "Keep the waters")->group("Molecules");
}

}  // namespace penumbra
