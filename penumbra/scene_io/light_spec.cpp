// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/light_spec.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <sstream>
#include <variant>

#include "penumbra/scene/error.h"
#include "penumbra/scene_io/numbers.h"

namespace penumbra {
namespace {

/// What follows the first word.
struct Form {
  std::string_view name, arguments;
  std::size_t count = 0;  ///< of numbers, without the colour
};

constexpr Form forms[] = {{"point", "x y z", 3},
                          {"sphere", "cx cy cz r", 4},
                          {"rect", "cx cy cz ux uy uz vx vy vz", 9},
                          {"sun", "dx dy dz degrees", 4}};

constexpr std::string_view later_forms[] = {"disk", "line", "polygon"};

const Form& form_named(const std::string& name) {
  for (const Form& form : forms)
    if (form.name == name) return form;
  for (const std::string_view later : later_forms)
    if (later == name)
      throw Error({}, fmt::format("this version does not know {} lights yet", name),
                  "use point, sphere, rect or sun");
  throw Error({}, "there is no light called " + in_quotes(name), "use point, sphere, rect or sun");
}

std::vector<double> numbers_of(const Form& form, std::span<const std::string> words) {
  const std::string hint = fmt::format("write `{} {} [r g b]`", form.name, form.arguments);
  if (words.size() != form.count && words.size() != form.count + 3)
    throw Error({},
                fmt::format("a {} light takes {} numbers, or {} with a colour, but has {}",
                            form.name, form.count, form.count + 3, words.size()),
                hint);
  std::vector<double> numbers;
  for (const std::string& word : words) {
    // Through float, so that the bits are those that a reader of floats gets.
    const std::optional<double> value = parse_double(word);
    const std::optional<float> narrow = parse_float(word);
    if (!value || !narrow || !std::isfinite(*narrow))
      throw Error({},
                  fmt::format("{} of a {} light is no finite number", in_quotes(word), form.name),
                  hint);
    numbers.push_back(form.name == "sun" && numbers.size() == 3 ? *value
                                                                : static_cast<double>(*narrow));
  }
  return numbers;
}

Vec3f vector_at(std::span<const double> n, std::size_t at) {
  return Vec3f(Vec3d(n[at], n[at + 1], n[at + 2]));
}

/// Unit length, and unchanged where it is so already to float precision: text keeps its bits.
Vec3f direction_at(std::span<const double> n, std::size_t at) {
  const Vec3f v = vector_at(n, at);
  return std::abs(length(Vec3d(v)) - 1) < 2e-7 ? v : normalize(v);
}

LightShape sphere_light(std::span<const double> n) {
  if (!(n[3] > 0)) throw Error({}, "a sphere light needs a radius above 0", "use point for none");
  return BallLight{vector_at(n, 0), static_cast<float>(n[3])};
}

LightShape rect_light(std::span<const double> n) {
  const ParallelogramLight light{vector_at(n, 0), vector_at(n, 3), vector_at(n, 6)};
  const Vec3d u = normalize(Vec3d(light.u)), v = normalize(Vec3d(light.v));
  if (!(length(cross(u, v)) > 1e-6))
    throw Error({}, "the half edges of a rect light are parallel or 0", "give two that span it");
  return light;
}

LightShape sun_light(std::span<const double> n) {
  const SunLight light{direction_at(n, 0), static_cast<float>(n[3] * std::numbers::pi / 360)};
  if (light.direction == Vec3f{}) throw Error({}, "a sun light needs a direction that is not 0");
  if (!(n[3] >= 0 && light.half_angle_rad < std::numbers::pi_v<float> / 2))
    throw Error({}, "a sun light's angular diameter is outside [0, 180) degrees", "use 0.53");
  return light;
}

std::string words_of(Vec3f v) {
  return fmt::format(" {} {} {}", to_text(v.x), to_text(v.y), to_text(v.z));
}

std::string words_of(std::span<const Vec3f> corners) {
  std::string words = fmt::format(" {}", corners.size());
  for (const Vec3f corner : corners) words += words_of(corner);
  return words;
}

/// Degrees that read back to this half angle.
std::string degrees_text(float half_angle_rad) {
  const double degrees = static_cast<double>(half_angle_rad) * 360 / std::numbers::pi;
  const std::string text = fmt::format("{:.6g}", degrees);
  const double back = parse_double(text).value_or(-1) * std::numbers::pi / 360;
  return static_cast<float>(back) == half_angle_rad ? text : fmt::format("{:.17g}", degrees);
}

struct Words {
  std::string operator()(const PointLight& l) const { return "point" + words_of(l.center); }
  std::string operator()(const BallLight& l) const {
    return fmt::format("sphere{} {}", words_of(l.center), to_text(l.radius));
  }
  std::string operator()(const ParallelogramLight& l) const {
    return "rect" + words_of(l.center) + words_of(l.u) + words_of(l.v);
  }
  std::string operator()(const DiskLight& l) const {
    return fmt::format("disk{}{} {}", words_of(l.center), words_of(l.normal), to_text(l.radius));
  }
  std::string operator()(const LineLight& l) const {
    return "line" + words_of(l.center - l.half) + words_of(l.center + l.half);
  }
  std::string operator()(const PolygonLight& l) const { return "polygon" + words_of(l.corners); }
  std::string operator()(const MeshLight& l) const { return "mesh" + words_of(l.corners); }
  std::string operator()(const SunLight& l) const {
    return fmt::format("sun{} {}", words_of(l.direction), degrees_text(l.half_angle_rad));
  }
};

}  // namespace

LightSpec parse_light_spec(std::span<const std::string> words) {
  if (words.empty())
    throw Error({}, "a light needs words", "write, for instance, `sphere 0 0 5 1`");
  const Form& form = form_named(words[0]);
  const std::vector<double> n = numbers_of(form, words.subspan(1));
  LightSpec spec;
  if (form.name == "point") spec.shape = PointLight{vector_at(n, 0)};
  if (form.name == "sphere") spec.shape = sphere_light(n);
  if (form.name == "rect") spec.shape = rect_light(n);
  if (form.name == "sun") spec.shape = sun_light(n);
  if (n.size() == form.count) return spec;
  spec.intensity = vector_at(n, form.count);
  const Color c = *spec.intensity;
  if (c.x < 0 || c.y < 0 || c.z < 0) throw Error({}, "a light's colour is below 0");
  return spec;
}

Light parse_light(std::span<const std::string> words) {
  const LightSpec spec = parse_light_spec(words);
  return {spec.shape, spec.intensity.value_or(Color{1, 1, 1}), Falloff::none};
}

std::vector<std::string> split_words(std::string_view text) {
  std::istringstream stream{std::string(text)};
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::string light_words(const Light& light) {
  return std::visit(Words{}, light.shape) + words_of(light.intensity);
}

}  // namespace penumbra
