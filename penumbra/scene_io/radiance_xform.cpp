// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "penumbra/scene_io/numbers.h"
#include "penumbra/scene_io/radiance_commands.h"
#include "penumbra/scene_io/text_lines.h"

namespace penumbra {
namespace {

/// Transformations that are applied together, so many times, or 0, 1, ... count - 1 times.
struct Segment {
  Transform map;
  std::int64_t count = 1;
  bool is_array = false;
};

/// The words of one xform with all -f replaced, taken one after the other.
struct Options {
  const std::vector<std::string>& words;
  const Error::Place& place;
  std::size_t at = 1;

  const std::string& take(const std::string& option) {
    if (at == words.size())
      throw Error(place, fmt::format("xform's {} has too few values", in_quotes(option)),
                  "see xform's manual page");
    return words[at++];
  }
  double number(const std::string& option) {
    const std::string& word = take(option);
    const std::optional<double> value = parse_double(word);
    if (value && std::isfinite(*value)) return *value;
    throw Error(place, fmt::format("xform's {} needs a number, not {}", option, in_quotes(word)),
                "see xform's manual page");
  }
  std::int64_t count(const std::string& option, std::int64_t least) {
    const std::string& word = take(option);
    const std::optional<std::int64_t> value = parse_integer(word);
    if (value && *value >= least) return *value;
    throw Error(place,
                fmt::format("xform's {} needs a whole number from {} up, not {}", option, least,
                            in_quotes(word)),
                "see xform's manual page");
  }
};

Transform rotation(int axis, double degrees) {
  // Quarter turns are exact, so that what was parallel to the axes stays so.
  const double turn = degrees / 90, radians = degrees * std::numbers::pi / 180;
  const bool is_exact = turn == std::round(turn) && std::abs(turn) < 1e6;
  const auto quarter = is_exact ? ((static_cast<std::int64_t>(turn) % 4) + 4) % 4 : 0;
  constexpr std::array<double, 4> sines{0, 1, 0, -1};
  const double s = is_exact ? sines[static_cast<std::size_t>(quarter)] : std::sin(radians);
  const double c =
      is_exact ? sines[static_cast<std::size_t>((quarter + 1) % 4)] : std::cos(radians);
  if (axis == 0) return {{1, 0, 0}, {0, c, s}, {0, -s, c}, {}};
  if (axis == 1) return {{c, 0, -s}, {0, 1, 0}, {s, 0, c}, {}};
  return {{c, s, 0}, {-s, c, 0}, {0, 0, 1}, {}};
}

/// The transformation that an option is, its values taken; nothing for other options.
std::optional<Transform> transformation(Options& options, const std::string& name) {
  Transform map;
  if (name == "-t") {
    for (int axis = 0; axis < 3; ++axis) map.offset[axis] = options.number(name);
    return map;
  }
  if (name == "-s") {
    const double scale = options.number(name);
    if (scale == 0)
      throw Error(options.place, "xform scales by 0", "give -s a number that is not 0");
    return Transform{{scale, 0, 0}, {0, scale, 0}, {0, 0, scale}, {}};
  }
  if (name.size() != 3 || name[2] < 'x' || name[2] > 'z') return std::nullopt;
  const int axis = name[2] - 'x';
  if (name[1] == 'r') return rotation(axis, options.number(name));
  if (name[1] != 'm') return std::nullopt;
  if (axis == 0) map.x_axis = -map.x_axis;
  if (axis == 1) map.y_axis = -map.y_axis;
  if (axis == 2) map.z_axis = -map.z_axis;
  return map;
}

/// By squares, so that no count takes long.
Transform power(Transform map, std::int64_t count) {
  Transform result;
  for (; count > 0; count /= 2, map = compose(map, map))
    if (count % 2 != 0) result = compose(map, result);
  return result;
}

/// All placements of the segments from `first` on, after `done`.
void place(const std::vector<Segment>& segments, std::size_t first, const Transform& done,
           std::vector<Transform>& placements) {
  if (first == segments.size()) return placements.push_back(done);
  const Segment& segment = segments[first];
  if (!segment.is_array)
    return place(segments, first + 1, compose(power(segment.map, segment.count), done), placements);
  Transform before = done;
  for (std::int64_t i = 0; i < segment.count; ++i) {
    place(segments, first + 1, before, placements);
    before = compose(segment.map, before);
  }
}

void check_number(const std::vector<Segment>& segments, std::size_t have, std::size_t most,
                  const Error::Place& where) {
  std::size_t number = 1;
  for (const Segment& segment : segments) {
    if (!segment.is_array) continue;
    if (static_cast<std::uint64_t>(segment.count) > most / number)
      number = most + 1;
    else
      number *= static_cast<std::size_t>(segment.count);
    if (number + have > most)
      throw Error(where, fmt::format("more than {} placements of files", most),
                  "give -a smaller counts, or split the scene");
  }
}

/// Options without -f; their placements are added to those that `xform` has.
void read_options(const std::vector<std::string>& words, std::size_t most,
                  const Error::Place& where, RadianceXform& xform) {
  Options options{words, where};
  std::vector<Segment> segments(1);
  std::string modifier;
  xform.is_inverted = false;
  while (options.at < words.size() && words[options.at].starts_with('-')) {
    const std::string name = words[options.at++];
    if (name == "-i" || name == "-a") {
      const bool is_array = name == "-a";
      segments.push_back({{}, options.count(name, is_array ? 1 : 0), is_array});
      if (segments.size() > 64)
        throw Error(where, "xform has more than 64 times -i and -a", "split it into several");
    } else if (name == "-m") {
      const std::string& value = options.take(name);
      if (modifier.empty()) modifier = value;  // as in xform, the first one counts
    } else if (name == "-n") {
      options.take(name);  // names of surfaces are not needed
    } else if (name == "-I") {
      xform.is_inverted = true;
    } else if (const auto map = transformation(options, name)) {
      segments.back().map = compose(*map, segments.back().map);
    } else if (name != "-c" && name != "-e") {
      throw Error(where, fmt::format("{} is no option of xform that is read", in_quotes(name)),
                  "use -t, -rx, -ry, -rz, -s, -mx, -my, -mz, -i, -a, -f, -m, -n and -I");
    }
  }
  xform.modifier = modifier;
  xform.files.assign(words.begin() + static_cast<std::ptrdiff_t>(options.at), words.end());
  check_number(segments, xform.placements.size(), most, where);
  place(segments, 0, {}, xform.placements);
}

/// Where -f stands among the options, or the end.
std::size_t argument_file(const std::vector<std::string>& words) {
  std::size_t i = 1;
  while (i < words.size() && words[i] != "-f") ++i;
  return i;
}

/// The words with -f replaced by those of one line of its file.
std::vector<std::string> with_line(const std::vector<std::string>& words, std::size_t at,
                                   std::string_view line) {
  std::vector<std::string> result(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(at));
  if (line.starts_with('!')) line.remove_prefix(1);
  const std::size_t first = result.size();
  for (std::string_view word = next_word(line); !word.empty(); word = next_word(line))
    result.emplace_back(word);
  if (first < result.size() && result[first] == "xform")
    result.erase(result.begin() + static_cast<std::ptrdiff_t>(first));
  result.insert(result.end(), words.begin() + static_cast<std::ptrdiff_t>(at) + 2, words.end());
  return result;
}

}  // namespace

RadianceXform parse_radiance_xform(const std::vector<std::string>& words, std::size_t most,
                                   const RadianceTextReader& read_text, const Error::Place& place) {
  RadianceXform xform;
  const std::size_t at = argument_file(words);
  if (at == words.size()) {
    read_options(words, most, place, xform);
    return xform;
  }
  if (at + 1 == words.size())
    throw Error(place, "xform's -f names no file", "name the file with the arguments");
  const std::string text = read_text(words[at + 1]);
  TextLines lines(text, LineJoints::none);
  std::optional<std::vector<std::string>> last;
  while (const auto line = lines.next()) {
    if (trimmed(*line).empty() || line->starts_with('#')) continue;
    last = with_line(words, at, *line);
    if (argument_file(*last) < last->size())
      throw Error(place, "xform's -f is given twice", "put all arguments into one file");
    read_options(*last, most, place, xform);
  }
  if (!last) throw Error(place, "the file of xform's -f is empty", "put a line of options into it");
  return xform;
}

}  // namespace penumbra
