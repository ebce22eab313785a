// SPDX-License-Identifier: MIT
// genbox: a box with a corner at the origin, its edges plain, bevelled or rounded.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "penumbra/geometry/vec.h"
#include "penumbra/scene_io/numbers.h"
#include "penumbra/scene_io/radiance_commands.h"

namespace penumbra {
namespace {

struct GenBox {
  std::string material, name;
  std::array<double, 3> size{};
  double bevel = 0, rounding = 0;
  bool is_inward = false;
};

[[noreturn]] void fail(const Error::Place& place, const std::string& what) {
  throw Error(place, what,
              "write `genbox material name xsize ysize zsize [-i] [-r radius|-b bevel]`");
}

double size_of(const std::vector<std::string>& words, std::size_t i, const Error::Place& place) {
  const std::optional<double> value =
      i < words.size() ? parse_double(words[i]) : std::optional<double>{};
  if (!value || !(*value > 0) || !std::isfinite(*value))
    fail(place, i < words.size()
                    ? fmt::format("genbox needs a size above 0, not {}", in_quotes(words[i]))
                    : "genbox has too few sizes");
  return *value;
}

GenBox read_box(const std::vector<std::string>& words, const Error::Place& place) {
  if (words.size() < 6) fail(place, "genbox has too few arguments");
  GenBox box{words[1], words[2]};
  for (std::size_t axis = 0; axis < 3; ++axis) box.size[axis] = size_of(words, 3 + axis, place);
  for (std::size_t i = 6; i < words.size(); ++i) {
    if (words[i] == "-i")
      box.is_inward = true;
    else if (words[i] == "-r")
      box.rounding = size_of(words, ++i, place);
    else if (words[i] == "-b")
      box.bevel = size_of(words, ++i, place);
    else
      fail(place, fmt::format("{} is no option of genbox that is read", in_quotes(words[i])));
  }
  const double inset = std::max(box.bevel, box.rounding);
  if (2 * inset >= *std::min_element(box.size.begin(), box.size.end()) ||
      (box.bevel > 0 && box.rounding > 0))
    fail(place, "genbox's -r or -b is too large for the box, or both are given");
  return box;
}

/// Writes the box's primitives; corners are given by how far along each axis they lie, -1 or 1, and
/// which axes stand back by the bevel or rounding.
class Writer {
 public:
  Writer(const GenBox& box, const Error::Place& place) : box_(box) {
    file_.path = place.file;
    line_ = place.line.value_or(1);
  }

  Vec3d corner(const std::array<int, 3>& side, const std::array<bool, 3>& stands_back) const {
    const double inset = std::max(box_.bevel, box_.rounding);
    Vec3d p;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double back = stands_back[axis] ? inset : 0;
      p[static_cast<int>(axis)] = side[axis] < 0 ? back : box_.size[axis] - back;
    }
    return p;
  }

  void add(const char* type, std::vector<double> numbers) {
    RadiancePrimitive p;
    p.modifier = box_.material;
    p.type = type;
    p.name = box_.name;
    p.numbers = std::move(numbers);
    p.line = line_;
    file_.statements.push_back(std::move(p));
  }

  /// The corners in order around it; turned about where it does not face `outward`.
  void polygon(std::vector<Vec3d> corners, Vec3d outward) {
    const Vec3d normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    if ((dot(normal, outward) < 0) != box_.is_inward) std::reverse(corners.begin(), corners.end());
    std::vector<double> numbers;
    for (Vec3d c : corners) numbers.insert(numbers.end(), {c.x, c.y, c.z});
    add("polygon", std::move(numbers));
  }

  RadianceFile take() { return std::move(file_); }

 private:
  const GenBox& box_;
  RadianceFile file_;
  std::size_t line_ = 1;
};

void add_faces(Writer& out) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const int sign : {-1, 1}) {
      const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
      std::array<bool, 3> back{true, true, true};
      back[axis] = false;
      std::vector<Vec3d> corners;
      for (const auto& [a, b] : {std::array{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        std::array<int, 3> side{};
        side[axis] = sign, side[u] = a, side[v] = b;
        corners.push_back(out.corner(side, back));
      }
      Vec3d outward;
      outward[static_cast<int>(axis)] = sign;
      out.polygon(std::move(corners), outward);
    }
}

/// The twelve edges along `axis` between the sides `a` and `b` of the two others.
void add_edge(Writer& out, const GenBox& box, std::size_t axis, int a, int b) {
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  std::array<int, 3> low{}, high{};
  low[axis] = -1, high[axis] = 1;
  low[u] = high[u] = a, low[v] = high[v] = b;
  if (box.rounding > 0) {
    const Vec3d p = out.corner(low, {true, true, true}), q = out.corner(high, {true, true, true});
    return out.add(box.is_inward ? "tube" : "cylinder",
                   {p.x, p.y, p.z, q.x, q.y, q.z, box.rounding});
  }
  std::array<bool, 3> on_u{true, true, true}, on_v = on_u;
  on_u[u] = false, on_v[v] = false;
  Vec3d outward;
  outward[static_cast<int>(u)] = a, outward[static_cast<int>(v)] = b;
  out.polygon({out.corner(low, on_u), out.corner(high, on_u), out.corner(high, on_v),
               out.corner(low, on_v)},
              outward);
}

void add_corner(Writer& out, const GenBox& box, const std::array<int, 3>& side) {
  if (box.rounding > 0) {
    const Vec3d p = out.corner(side, {true, true, true});
    return out.add(box.is_inward ? "bubble" : "sphere", {p.x, p.y, p.z, box.rounding});
  }
  out.polygon({out.corner(side, {false, true, true}), out.corner(side, {true, false, true}),
               out.corner(side, {true, true, false})},
              Vec3d(side[0], side[1], side[2]));
}

}  // namespace

RadianceFile radiance_box(const std::vector<std::string>& words, const Error::Place& place) {
  const GenBox box = read_box(words, place);
  Writer out(box, place);
  add_faces(out);
  if (box.bevel > 0 || box.rounding > 0) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int a : {-1, 1})
        for (const int b : {-1, 1}) add_edge(out, box, axis, a, b);
    for (const int x : {-1, 1})
      for (const int y : {-1, 1})
        for (const int z : {-1, 1}) add_corner(out, box, {x, y, z});
  }
  return out.take();
}

}  // namespace penumbra
