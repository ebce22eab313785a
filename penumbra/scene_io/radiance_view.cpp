// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/radiance_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "penumbra/scene_io/light_spec.h"
#include "penumbra/scene_io/numbers.h"
#include "penumbra/scene_io/source.h"
#include "penumbra/scene_io/text_lines.h"

namespace penumbra {
namespace {

/// Radiance's standard view, where nothing is given.
struct View {
  char type = 'v';
  Vec3d from, direction{0, 1, 0}, up{0, 0, 1};
  double horizontal = 45, vertical = 45;  ///< degrees; of parallel views scene units
  double fore = 0, aft = 0, shift = 0, lift = 0;
};

constexpr int deepest = 8;  ///< view files that name one another
constexpr std::uint32_t picture_height = 512, most_pixels = 4096;

struct Reader {
  View& view;
  std::filesystem::path beside;
  int depth = 0;
  Error::Place place{};
};

bool read_lines(Reader& reader, const std::filesystem::path& file);

double number(const Reader& reader, const std::vector<std::string>& words, std::size_t i) {
  if (i < words.size())
    if (const auto value = parse_double(words[i]); value && std::isfinite(*value)) return *value;
  throw Error(reader.place,
              i < words.size() ? fmt::format("a view needs a number, not {}", in_quotes(words[i]))
                               : "a view option has too few numbers",
              "write a view such as `-vtv -vp 0 -5 1 -vd 0 1 0 -vu 0 0 1 -vh 45 -vv 45`");
}

/// How many words an option takes with it, itself included; 0: it is none of a view.
std::size_t take_option(Reader& reader, const std::vector<std::string>& words, std::size_t i) {
  const std::string& word = words[i];
  if (word.size() < 3 || !word.starts_with("-v")) return 0;
  View& view = reader.view;
  if (word[2] == 't') {
    if (word.size() != 4) return 0;
    view.type = word[3];
    return 1;
  }
  if (word.size() != 3) return 0;
  const auto vector = [&] {
    return Vec3d(number(reader, words, i + 1), number(reader, words, i + 2),
                 number(reader, words, i + 3));
  };
  switch (word[2]) {
    case 'p': view.from = vector(); return 4;
    case 'd': view.direction = vector(); return 4;
    case 'u': view.up = vector(); return 4;
    case 'h': view.horizontal = number(reader, words, i + 1); return 2;
    case 'v': view.vertical = number(reader, words, i + 1); return 2;
    case 'o': view.fore = number(reader, words, i + 1); return 2;
    case 'a': view.aft = number(reader, words, i + 1); return 2;
    case 's': view.shift = number(reader, words, i + 1); return 2;
    case 'l': view.lift = number(reader, words, i + 1); return 2;
    case 'f':
      if (i + 1 == words.size())
        throw Error(reader.place, "-vf names no view file", "name one after it");
      // The name may be as long as a file: it is quoted, not the place of an error.
      if (std::error_code ignored; !std::filesystem::exists(reader.beside / words[i + 1], ignored))
        throw Error(reader.place, fmt::format("there is no view file {}", in_quotes(words[i + 1])),
                    "put it beside the file that names it");
      if (!read_lines(reader, reader.beside / words[i + 1]))
        throw Error(reader.place, fmt::format("{} holds no view", in_quotes(words[i + 1])),
                    "a view file has a line such as `rvu -vtv -vp 0 -5 1 -vd 0 1 0`");
      return 2;
    default: return 0;
  }
}

/// True if there was any view option among them.
bool read_options(Reader& reader, const std::vector<std::string>& words) {
  bool is_any = false;
  for (std::size_t i = 0; i < words.size();) {
    const std::size_t taken = take_option(reader, words, i);
    is_any = is_any || taken > 0;
    i += std::max<std::size_t>(taken, 1);
  }
  return is_any;
}

/// Lines that rvu takes for views.
bool is_view_line(std::string_view line) {
  std::string_view rest = line;
  const std::string_view first = next_word(rest);
  constexpr std::array<std::string_view, 8> programs{"rvu",     "rview", "rpict",   "rpiece",
                                                     "pinterp", "rad",   "mkillum", "objview"};
  if (first.starts_with("VIEW=") || first.starts_with("-v")) return true;
  const std::string_view program = first.substr(std::min(first.rfind('/') + 1, first.size()));
  return std::find(programs.begin(), programs.end(), program) != programs.end();
}

bool read_lines(Reader& reader, const std::filesystem::path& file) {
  if (reader.depth == deepest)
    throw Error(reader.place, "view files name one another without end", "take a -vf out");
  const Source source = load(file);
  Reader inner{reader.view, file.parent_path(), reader.depth + 1};
  inner.place.file = file.string();
  TextLines lines(source.bytes, LineJoints::backslash);
  bool is_any = false;
  while (const auto line = lines.next()) {
    if (!is_view_line(*line)) continue;
    inner.place.line = lines.number();
    std::string text(line->starts_with("VIEW=") ? line->substr(5) : *line);
    std::replace(text.begin(), text.end(), '\\', ' ');
    is_any = read_options(inner, split_words(text)) || is_any;
  }
  return is_any;
}

[[noreturn]] void fail(const Reader& reader, const char* what, const char* hint) {
  throw Error(reader.place, what, hint);
}

/// Picture size of this aspect (width / height).
void set_size(Camera& camera, double aspect) {
  const auto pixels = [](double n) {
    return static_cast<std::uint32_t>(std::clamp(std::round(n), 1.0, double{most_pixels}));
  };
  camera.height = picture_height;
  camera.width = pixels(picture_height * aspect);
  if (camera.width < most_pixels) return;
  camera.height = pixels(most_pixels / aspect);
}

RadianceView to_camera(const Reader& reader) {
  const View& v = reader.view;
  RadianceView result;
  Camera& camera = result.camera;
  if (normalize(v.direction) == Vec3d{} ||
      length(cross(normalize(v.direction), normalize(v.up))) < 1e-9)
    fail(reader, "the view's direction is 0, or along its up", "give -vd and -vu that differ");
  if (!(v.horizontal > 0) || !(v.vertical > 0))
    fail(reader, "the view's size is not above 0", "give -vh and -vv numbers above 0");
  camera.from = v.from;
  camera.at = v.from + normalize(v.direction);
  camera.up = v.up;
  camera.near = std::max(v.fore, 0.0);
  camera.window = {v.shift, -v.lift, 1 + v.shift, 1 - v.lift};
  if (v.aft > 0) result.warning = "the aft clipping plane of the view (-va) is not there";
  if (v.type == 'l') {
    camera.parallel_height = v.vertical;
    set_size(camera, v.horizontal / v.vertical);
    return result;
  }
  double horizontal = v.horizontal, vertical = v.vertical;
  if (v.type != 'v') {
    constexpr std::string_view others = "hacs";
    if (others.find(v.type) == std::string_view::npos)
      fail(reader, "the view is of a type that Radiance does not have", "use -vtv or -vtl");
    constexpr double widest = 100;
    horizontal = std::min(horizontal, widest), vertical = std::min(vertical, widest);
    result.warning = fmt::format(
        "a view of type -vt{} is drawn in perspective, {:.3g} x {:.3g} "
        "degrees",
        v.type, horizontal, vertical);
  } else if (horizontal >= 180 || vertical >= 180) {
    fail(reader, "the view's angle is 180 degrees or more", "give -vh and -vv smaller ones");
  }
  const auto tangent = [](double degrees) { return std::tan(degrees * std::numbers::pi / 360); };
  camera.fov_deg = vertical;
  set_size(camera, tangent(horizontal) / tangent(vertical));
  return result;
}

}  // namespace

RadianceView parse_radiance_view(std::string_view text, const std::filesystem::path& beside) {
  const std::vector<std::string> words = split_words(text);
  if (words.empty()) throw Error({}, "the view is empty", "give a view file, or view options");
  if (!words[0].starts_with('-')) return read_radiance_view(beside / std::string(trimmed(text)));
  View view;
  Reader reader{view, beside};
  for (std::size_t i = 0; i < words.size();) {
    const std::size_t taken = take_option(reader, words, i);
    if (taken == 0)
      throw Error({}, fmt::format("{} is no option of a view", in_quotes(words[i])),
                  "use -vtv -vtl -vp -vd -vu -vh -vv -vo -vs -vl and -vf");
    i += taken;
  }
  return to_camera(reader);
}

RadianceView read_radiance_view(const std::filesystem::path& file) {
  View view;
  Reader reader{view, {}};
  reader.place.file = file.string();
  if (!read_lines(reader, file))
    throw Error({file.string(), {}, {}}, "holds no view",
                "a view file has a line such as `rvu -vtv -vp 0 -5 1 -vd 0 1 0`");
  return to_camera(reader);
}

}  // namespace penumbra
