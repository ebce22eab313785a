// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/light_spec.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <sstream>
#include <variant>

#include "penumbra/geometry/centroid.h"
#include "penumbra/geometry/convex_hull.h"
#include "penumbra/scene/check_light.h"
#include "penumbra/scene/error.h"
#include "penumbra/scene_io/numbers.h"

namespace penumbra {
namespace {

/// What follows the first word.
struct Form {
  std::string_view name, arguments;
  std::size_t count = 0;  ///< of numbers, without the colour; 0: a count of points comes first
};

constexpr Form forms[] = {{"point", "x y z", 3},
                          {"sphere", "cx cy cz r", 4},
                          {"rect", "cx cy cz ux uy uz vx vy vz", 9},
                          {"disk", "cx cy cz nx ny nz r", 7},
                          {"line", "ax ay az bx by bz", 6},
                          {"polygon", "n x1 y1 z1 ... xn yn zn"},
                          {"mesh", "n x1 y1 z1 ... xn yn zn"},
                          {"sun", "dx dy dz degrees", 4}};

const Form& form_named(const std::string& name) {
  for (const Form& form : forms)
    if (form.name == name) return form;
  throw Error({}, "there is no light called " + in_quotes(name),
              "use point, sphere, rect, disk, line, polygon, mesh or sun");
}

std::string usage(const Form& form) {
  return fmt::format("write `{} {} [r g b]`", form.name, form.arguments);
}

/// How many numbers there must be, without the colour.
std::size_t number_count(const Form& form, std::span<const std::string> words) {
  if (form.count > 0) return form.count;
  constexpr std::int64_t most = 1'000'000;
  const auto points = words.empty() ? std::nullopt : parse_integer(words[0]);
  if (!points || *points < 1 || *points > most)
    throw Error(
        {}, fmt::format("the first number of a {} light is not how many points follow", form.name),
        usage(form));
  return 1 + 3 * static_cast<std::size_t>(*points);
}

/// Degrees, and the ends of lines, whose middle and half are the floats.
bool is_double(const Form& form, std::size_t i) {
  return (form.name == "sun" && i == 3) || (form.name == "line" && i < 6);
}

std::vector<double> numbers_of(const Form& form, std::size_t count,
                               std::span<const std::string> words) {
  if (words.size() != count && words.size() != count + 3)
    throw Error(
        {},
        fmt::format("{} {} light takes {} numbers, or {} with a colour, but has {}",
                    form.count > 0 ? "a" : "this", form.name, count, count + 3, words.size()),
        usage(form));
  std::vector<double> numbers;
  for (const std::string& word : words) {
    // Through float, so that the bits are those that a reader of floats gets.
    const std::optional<double> value = parse_double(word);
    const std::optional<float> narrow = parse_float(word);
    if (!value || !narrow || !std::isfinite(*narrow))
      throw Error({},
                  fmt::format("{} of a {} light is no finite number", in_quotes(word), form.name),
                  usage(form));
    numbers.push_back(is_double(form, numbers.size()) ? *value : static_cast<double>(*narrow));
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

/// What only the finished shape shows.
LightShape checked(const Form& form, LightShape light) {
  if (const std::optional<LightProblem> problem = problem_of(light))
    throw Error({}, fmt::format("a {} light {}", form.name, problem->what), problem->hint);
  return light;
}

LightShape disk_light(std::span<const double> n) {
  return DiskLight{vector_at(n, 0), direction_at(n, 3), static_cast<float>(n[6])};
}

LightShape line_light(std::span<const double> n) {
  const Vec3d a(n[0], n[1], n[2]), b(n[3], n[4], n[5]);
  return LineLight{Vec3f((a + b) * 0.5), Vec3f((b - a) * 0.5)};
}

/// Of a count and as many points.
std::vector<Vec3f> points_of(std::span<const double> n) {
  std::vector<Vec3f> points;
  for (std::size_t i = 1; i + 2 < n.size(); i += 3) points.push_back(vector_at(n, i));
  return points;
}

LightShape polygon_light(std::span<const double> n) {
  PolygonLight light{{}, points_of(n)};
  light.center = area_centroid(light.corners);
  return light;
}

LightShape mesh_light(std::span<const double> n) {
  const std::vector<Vec3f> points = points_of(n);
  std::optional<MeshLight> hull = convex_hull(points);
  if (!hull)
    throw Error({}, "the points of a mesh light enclose no volume",
                "give at least 4 that are not in one plane, or use polygon");
  return *std::move(hull);
}

LightShape sun_light(std::span<const double> n) {
  const SunLight light{direction_at(n, 0), static_cast<float>(n[3] * std::numbers::pi / 360)};
  if (light.direction == Vec3f{}) throw Error({}, "a sun light needs a direction that is not 0");
  if (!(n[3] >= 0 && light.half_angle_rad < std::numbers::pi_v<float> / 2))
    throw Error({}, "a sun light's angular diameter is outside [0, 180) degrees", "use 0.53");
  return light;
}

LightShape shape_of(const Form& form, std::span<const double> n) {
  if (form.name == "sphere") return sphere_light(n);
  if (form.name == "rect") return rect_light(n);
  if (form.name == "disk") return disk_light(n);
  if (form.name == "line") return line_light(n);
  if (form.name == "polygon") return polygon_light(n);
  if (form.name == "mesh") return mesh_light(n);
  if (form.name == "sun") return sun_light(n);
  return PointLight{vector_at(n, 0)};
}

template <typename Number>
std::string words_of(Vec3<Number> v) {
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

/// 0 at 90 degrees, which pi cannot express.
float cosine_of(double degrees) {
  const double cosine = std::cos(degrees * std::numbers::pi / 180);
  return std::abs(cosine) < 1e-12 ? 0 : static_cast<float>(cosine);
}

/// Degrees that read back to this cosine.
std::string angle_text(float cosine) {
  const double degrees = std::acos(static_cast<double>(cosine)) * 180 / std::numbers::pi;
  const std::string text = fmt::format("{:.6g}", degrees);
  return cosine_of(parse_double(text).value_or(-1)) == cosine ? text
                                                              : fmt::format("{:.17g}", degrees);
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
    const Vec3d center(l.center), half(l.half);
    return "line" + words_of(center - half) + words_of(center + half);
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
  const auto own =
      static_cast<std::size_t>(std::find(words.begin(), words.end(), "beam") - words.begin());
  const Form& form = form_named(words[0]);
  const std::span<const std::string> of_shape = words.first(own).subspan(1);
  const std::size_t count = number_count(form, of_shape);
  const std::vector<double> all = numbers_of(form, count, of_shape);
  LightSpec spec{checked(form, shape_of(form, std::span(all).first(count))), {}, {}};
  if (own < words.size()) spec.beam = parse_beam(words.subspan(own + 1), spec.shape);
  if (all.size() == count) return spec;
  spec.intensity = vector_at(all, count);
  const Color c = *spec.intensity;
  if (c.x < 0 || c.y < 0 || c.z < 0) throw Error({}, "a light's colour is below 0");
  return spec;
}

Light parse_light(std::span<const std::string> words) {
  const LightSpec spec = parse_light_spec(words);
  return {spec.shape, spec.intensity.value_or(Color{1, 1, 1}), Falloff::none, spec.beam};
}

Beam parse_beam(std::span<const std::string> words, const LightShape& light) {
  constexpr const char* hint = "write `beam ax ay az full_deg none_deg`";
  if (words.size() != 5)
    throw Error({}, fmt::format("a beam takes 5 numbers, but has {}", words.size()), hint);
  std::vector<double> n;
  for (const std::string& word : words) {
    const std::optional<double> value = parse_double(word);
    if (!value || !std::isfinite(static_cast<float>(*value)))
      throw Error({}, fmt::format("{} of a beam is no finite number", in_quotes(word)), hint);
    n.push_back(*value);
  }
  if (!(n[3] >= 0 && n[3] <= n[4] && n[4] <= 180))
    throw Error({}, "a beam's angles are out of order or outside [0, 180] degrees",
                "give the angle of full light first, then that of none");
  const Beam beam{direction_at(n, 0), cosine_of(n[3]), cosine_of(n[4])};
  if (const std::optional<LightProblem> problem = problem_of(beam, light))
    throw Error({}, fmt::format("the light {}", problem->what), problem->hint);
  return beam;
}

std::vector<std::string> split_words(std::string_view text) {
  std::istringstream stream{std::string(text)};
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::string light_words(const Light& light) {
  return std::visit(Words{}, light.shape) + words_of(light.intensity) +
         (light.beam ? " beam " + beam_words(*light.beam) : "");
}

std::string beam_words(const Beam& beam) {
  return fmt::format("{} {} {} {} {}", to_text(beam.axis.x), to_text(beam.axis.y),
                     to_text(beam.axis.z), angle_text(beam.cos_full), angle_text(beam.cos_none));
}

}  // namespace penumbra
