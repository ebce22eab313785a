// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

#include "penumbra/scene_io/numbers.h"
#include "penumbra/scene_io/pbrt_parser.h"

namespace penumbra {
namespace {

/// Sets the current transformation; at the shutter's closing nothing is drawn.
void set(PbrtParser& parser, const Transform& t) {
  if (parser.pbrt.graphics.moves_start) parser.pbrt.graphics.to_world = t;
}

/// What is written later acts first.
void concat(PbrtParser& parser, const Transform& t) {
  set(parser, compose(parser.pbrt.graphics.to_world, t));
}

Vec3d read_vector(PbrtTokens& tokens, std::string_view what) {
  const double x = tokens.number(what), y = tokens.number(what), z = tokens.number(what);
  return {x, y, z};
}

/// 16 numbers, the images of the axes and of the origin one after the other.
Transform read_matrix(PbrtTokens& tokens, PbrtPlace place) {
  const bool has_brackets = tokens.peek().kind == PbrtTokenKind::open;
  if (has_brackets) tokens.next();
  std::array<double, 16> m{};
  for (double& number : m) number = tokens.number("one of 16 numbers of a matrix");
  if (has_brackets)
    if (const PbrtToken token = tokens.next(); token.kind != PbrtTokenKind::close)
      fail_pbrt_token(token, "`]` after 16 numbers");
  if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] == 0)
    throw Error(place, "a matrix whose every fourth number is not 0 0 0 1",
                "projections are no placement: give an affine map");
  for (double& number : m) number /= m[15];
  return {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
}

void identity(PbrtParser& parser, PbrtTokens&, PbrtPlace) { set(parser, {}); }

void translate(PbrtParser& parser, PbrtTokens& tokens, PbrtPlace) {
  Transform t;
  t.offset = read_vector(tokens, "a translation");
  concat(parser, t);
}

void scale(PbrtParser& parser, PbrtTokens& tokens, PbrtPlace) {
  const Vec3d s = read_vector(tokens, "a scale");
  concat(parser, {{s.x, 0, 0}, {0, s.y, 0}, {0, 0, s.z}, {}});
}

/// Rodrigues' formula, column by column.
void rotate(PbrtParser& parser, PbrtTokens& tokens, PbrtPlace place) {
  const double angle = tokens.number("an angle in degrees") * std::numbers::pi / 180;
  const Vec3d axis = normalize(read_vector(tokens, "an axis"));
  if (axis == Vec3d{}) throw Error(place, "a rotation about no axis", "give one that is not 0");
  const double c = std::cos(angle), s = std::sin(angle);
  const auto turned = [&](Vec3d v) {
    return v * c + cross(axis, v) * s + axis * (dot(axis, v) * (1 - c));
  };
  concat(parser, {turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1}), {}});
}

/// From the world to an eye that looks along its z; its x axis is up x forward, so the frame is
/// left-handed in what we call the world.
void look_at(PbrtParser& parser, PbrtTokens& tokens, PbrtPlace place) {
  const Vec3d eye = read_vector(tokens, "a point to look from"),
              at = read_vector(tokens, "a point to look at"),
              up = read_vector(tokens, "a direction that is up");
  const Vec3d z = normalize(at - eye), x = normalize(cross(normalize(up), z));
  if (z == Vec3d{} || length(cross(normalize(up), z)) < 1e-9)
    throw Error(place, "LookAt's `up` is along its line of sight, or there is none",
                "give another direction, and two points that differ");
  const auto world_from_eye = Transform{x, cross(z, x), z, eye};
  if (const auto eye_from_world = inverse(world_from_eye)) concat(parser, *eye_from_world);
}

void coordinate_system(PbrtParser& parser, PbrtTokens& tokens, PbrtPlace) {
  parser.pbrt.coordinate_systems.insert_or_assign(tokens.text("a name in quotation marks"),
                                                  parser.pbrt.graphics.to_world);
}

void coord_sys_transform(PbrtParser& parser, PbrtTokens& tokens, PbrtPlace place) {
  const std::string name = tokens.text("a name in quotation marks");
  const auto known = parser.pbrt.coordinate_systems.find(name);
  if (known == parser.pbrt.coordinate_systems.end())
    throw Error(place, "there is no coordinate system " + in_quotes(name),
                "name one with CoordinateSystem before");
  parser.pbrt.graphics.to_world = known->second;  // of all times, whichever is active
}

void transform(PbrtParser& parser, PbrtTokens& tokens, PbrtPlace place) {
  set(parser, read_matrix(tokens, place));
}

void concat_transform(PbrtParser& parser, PbrtTokens& tokens, PbrtPlace place) {
  concat(parser, read_matrix(tokens, place));
}

void reverse_orientation(PbrtParser& parser, PbrtTokens&, PbrtPlace) {
  parser.pbrt.graphics.is_reversed = !parser.pbrt.graphics.is_reversed;
}

constexpr const char* no_motion = "nothing moves: all is where it is when the shutter opens";

void transform_times(PbrtParser& parser, PbrtTokens& tokens, PbrtPlace place) {
  tokens.number("a time");
  tokens.number("a time");
  parser.pbrt.warnings.add(no_motion, place);
}

void active_transform(PbrtParser& parser, PbrtTokens& tokens, PbrtPlace place) {
  const PbrtToken token = tokens.next();
  if (token.text != "All" && token.text != "StartTime" && token.text != "EndTime")
    fail_pbrt_token(token, "All, StartTime or EndTime");
  bool& moves_start = parser.pbrt.graphics.moves_start;
  moves_start = token.text != "EndTime";
  if (!moves_start) parser.pbrt.warnings.add(no_motion, place);
}

/// What AttributeBegin is: pbrt-v4 has given up the difference.
void transform_begin(PbrtParser& parser, PbrtTokens&, PbrtPlace place) {
  open_pbrt_block(parser, "TransformBegin", place);
}

void transform_end(PbrtParser& parser, PbrtTokens&, PbrtPlace place) {
  close_pbrt_block(parser, "TransformBegin", "TransformEnd", place);
}

struct Entry {
  std::string_view name;
  PbrtDirective read;
};

constexpr Entry directives[] = {{"Identity", identity},
                                {"Translate", translate},
                                {"Scale", scale},
                                {"Rotate", rotate},
                                {"LookAt", look_at},
                                {"CoordinateSystem", coordinate_system},
                                {"CoordSysTransform", coord_sys_transform},
                                {"Transform", transform},
                                {"ConcatTransform", concat_transform},
                                {"ReverseOrientation", reverse_orientation},
                                {"TransformTimes", transform_times},
                                {"ActiveTransform", active_transform},
                                {"TransformBegin", transform_begin},
                                {"TransformEnd", transform_end}};

}  // namespace

PbrtDirective find_pbrt_transformation(std::string_view name) {
  const auto found = std::find_if(std::begin(directives), std::end(directives),
                                  [&](const Entry& entry) { return entry.name == name; });
  return found == std::end(directives) ? nullptr : found->read;
}

}  // namespace penumbra
