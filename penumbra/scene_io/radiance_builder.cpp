// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/radiance_builder.h"

#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "penumbra/scene/coordinates.h"
#include "penumbra/scene_io/numbers.h"

namespace penumbra {
namespace {

constexpr std::size_t most_placements = std::size_t{1} << 19;
constexpr std::size_t deepest = 64;
// In statements: what a placement costs when it is listed and when it is made, and a surface of a
// file that becomes another group. All keep memory.
constexpr std::size_t listing_cost = 16, placement_cost = 16, surface_cost = 4;

Error::Place place_of(const RadianceFile& file, const RadiancePrimitive& p) {
  return {file.path.string(), p.line, {}};
}

RadianceSide side_of(bool is_inverted) {
  return is_inverted ? RadianceSide::inverted : RadianceSide::as_it_is;
}

/// What a file's placement does, and then `outer`.
RadiancePlacement composed(const RadiancePlacement& outer, const RadiancePlacement& inner) {
  return {compose(outer.map, inner.map), outer.is_inverted != inner.is_inverted,
          outer.modifier.empty() ? inner.modifier : outer.modifier};
}

bool is_sensible(const Transform& t) {
  return is_coordinate(t.x_axis) && is_coordinate(t.y_axis) && is_coordinate(t.z_axis) &&
         is_coordinate(t.offset) && std::abs(determinant(t)) > 1e-45;
}

}  // namespace

RadianceBuilder::RadianceBuilder(Scene& scene, Warnings& warnings, std::filesystem::path main)
    : scene_(scene), warnings_(warnings), main_(std::move(main)), library_(main_) {}

void RadianceBuilder::warn(const std::string& kind, const RadianceFile& file, std::size_t line) {
  const bool is_main = file.path == main_;
  const auto [text, is_new] = kinds_.try_emplace(
      kind, is_main ? kind : fmt::format("{} (first in {}:{})", kind, file.path.string(), line));
  warnings_.add(text->second, is_main ? line : 0);
}

void RadianceBuilder::spend(std::size_t statements, const RadianceFile& file) {
  if (statements > statements_left_)
    throw Error(
        {file.path.string(), {}, {}},
        "its commands expand to more than 16 million statements or half a million placements",
        "use smaller arrays, or split the scene");
  statements_left_ -= statements;
}

void RadianceBuilder::read_main(const RadianceFile& file) {
  bool ignored = true;
  add_shapes(scene_.shapes, polygons_, file, read_statements(file, {}, ignored), false);
}

std::optional<std::uint32_t> RadianceBuilder::read(const RadianceFile& file,
                                                   const RadiancePlacement& placement) {
  bool is_repeatable = true;
  const Surfaces surfaces = read_statements(file, placement, is_repeatable);
  if (surfaces.empty()) return std::nullopt;
  const std::uint32_t group = group_of(file, surfaces, placement.is_inverted);
  scene_.shapes.instances.push_back({group, placement.map});
  return is_repeatable ? std::optional(group) : std::nullopt;
}

RadianceBuilder::Surfaces RadianceBuilder::read_statements(const RadianceFile& file,
                                                           const RadiancePlacement& placement,
                                                           bool& is_repeatable) {
  for (const RadianceFile* above : open_)
    if (above == &file)
      throw Error({file.path.string(), {}, {}}, "the file includes itself",
                  "take the `!xform` of it out");
  if (open_.size() == deepest)
    throw Error({file.path.string(), {}, {}}, "more than 64 files include one another",
                "join some of them");
  // A file's first time is paid for by its length.
  spend(placement_cost + (known_.insert(&file).second ? 0 : file.statements.size()), file);
  open_.push_back(&file);
  Surfaces surfaces;
  for (const RadiancePrimitive& p : file.statements) {
    if (p.is_command()) {
      is_repeatable = false;
      run(file, p, placement);
    } else if (is_radiance_surface(p.type)) {
      if (const auto surface = read_surface(file, p, placement, is_repeatable))
        surfaces.push_back({&p, *surface});
    } else {
      modifiers_.define(file, p, placement.map);
      is_repeatable = is_repeatable && p.type != "spotlight";
    }
  }
  open_.pop_back();
  return surfaces;
}

void RadianceBuilder::run(const RadianceFile& file, const RadiancePrimitive& p,
                          const RadiancePlacement& placement) {
  const Command& command = parsed(file, p);
  std::optional<std::uint32_t> before;
  bool is_settled = false;  // two placements gave the same group: so will all others
  for (const RadiancePlacement& inner : command.placements) {
    const RadiancePlacement whole = composed(placement, inner);
    if (!is_sensible(whole.map))
      throw Error(place_of(file, p), "the command moves or scales beyond 1e15, or to nothing",
                  "check its numbers");
    if (is_settled) {
      spend(placement_cost, file);
      scene_.shapes.instances.push_back({*before, whole.map});
      continue;
    }
    for (const RadianceFile* included : command.files) {
      const std::optional<std::uint32_t> group = read(*included, whole);
      is_settled = command.files.size() == 1 && group && group == before;
      before = group;
    }
  }
}

const RadianceBuilder::Command& RadianceBuilder::parsed(const RadianceFile& file,
                                                        const RadiancePrimitive& p) {
  const auto [command, is_new] = commands_.try_emplace(&p);
  if (is_new) parse(file, p, command->second);
  return command->second;
}

void RadianceBuilder::parse(const RadianceFile& file, const RadiancePrimitive& p, Command& result) {
  const Error::Place place = place_of(file, p);
  result.placements.emplace_back();
  const std::vector<std::vector<std::string>> programs = split_radiance_command(p.words[0], place);
  for (std::size_t i = 0; i < programs.size(); ++i) {
    const std::vector<std::string>& words = programs[i];
    const std::string program = std::filesystem::path(words[0]).filename().string();
    std::vector<std::string> names;
    if (program == "xform") {
      const RadianceXform xform = parse_radiance_xform(
          words, most_placements / result.placements.size(),
          [&](const std::string& name) { return library_.text(name, place); }, place);
      names = xform.files;
      spend(listing_cost * xform.placements.size() * result.placements.size(), file);
      std::vector<RadiancePlacement> placements;
      for (const Transform& map : xform.placements)
        for (const RadiancePlacement& inner : result.placements)
          placements.push_back(composed({map, xform.is_inverted, xform.modifier}, inner));
      result.placements = std::move(placements);
    } else if (program == "cat" && i == 0) {
      names.assign(words.begin() + 1, words.end());
    } else if (program == "genbox" && i == 0) {
      result.files.push_back(&library_.keep(radiance_box(words, place)));
    } else {
      refuse_radiance_command(program, place);
    }
    if (i > 0 ? !names.empty() : names.empty() && result.files.empty())
      throw Error(place,
                  i > 0 ? "a command after a pipe names a file" : "the command names no file",
                  "name a file in the first command of a pipe, and there alone");
    for (const std::string& name : names) {
      if (name.starts_with('-') || name.starts_with('!'))
        throw Error(place, fmt::format("{} reads from somewhere else than a file", program),
                    "commands are not run: expand it first, as in `xform -e scene.rad > all.rad`");
      result.files.push_back(&library_.open(name, place));
    }
  }
}

std::uint32_t RadianceBuilder::group_of(const RadianceFile& file, const Surfaces& surfaces,
                                        bool is_inverted) {
  std::vector<std::uint32_t> materials;
  materials.reserve(surfaces.size());
  for (const Surface& s : surfaces) materials.push_back(s.surface);
  const auto next = static_cast<std::uint32_t>(scene_.shapes.groups.size());
  const auto [group, is_new] =
      groups_.try_emplace({&file, is_inverted, std::move(materials)}, next);
  if (!is_new) return group->second;
  if (!grouped_.insert(&file).second) spend(surface_cost * surfaces.size(), file);
  ShapeSet shapes;
  Mesh polygons;
  add_shapes(shapes, polygons, file, surfaces, is_inverted);
  finish_polygons(shapes, std::move(polygons));
  scene_.shapes.groups.push_back(std::move(shapes));
  return next;
}

void RadianceBuilder::add_shapes(ShapeSet& shapes, Mesh& polygons, const RadianceFile& file,
                                 const Surfaces& surfaces, bool is_inverted) {
  for (const Surface& s : surfaces) {
    const RadianceShape shape = radiance_shape(file, *s.primitive, side_of(is_inverted));
    if (shape.kind == RadianceShape::Kind::none)
      warn("surfaces without any size are left out", file, s.primitive->line);
    add_shape(shapes, polygons, shape, s.surface);
  }
}

void RadianceBuilder::warn_of(std::uint32_t modifier, const RadianceLook& look,
                              const RadianceFile& file, const RadiancePrimitive& p) {
  constexpr std::uint32_t none = RadianceModifier::none;
  if (!look.warning.empty()) warn(look.warning, file, p.line);
  if ((modifier == none || modifiers_[modifier].material == none) && p.type != "source")
    warn("surfaces without a material (void) are grey", file, p.line);
  const std::uint32_t odd = modifier == none ? none : modifiers_[modifier].oddity;
  if (odd == none) return;
  const bool lights =
      look.emission == RadianceEmission::light || look.emission == RadianceEmission::illum;
  const char* fate = lights
                         ? "read: its lights are as bright in all directions as their material says"
                         : "drawn: its surfaces are plain";
  warn(fmt::format("{} is not {}", modifiers_[odd].primitive->type, fate), file, p.line);
}

std::optional<std::uint32_t> RadianceBuilder::read_surface(const RadianceFile& file,
                                                           const RadiancePrimitive& p,
                                                           const RadiancePlacement& placement,
                                                           bool& is_repeatable) {
  if (p.type == "instance" || p.type == "mesh") {
    const std::string stem =
        p.words.empty() ? "scene" : std::filesystem::path(p.words[0]).stem().string();
    throw Error(place_of(file, p),
                fmt::format("{} {}: {} can't be read", p.type, in_quotes(p.name),
                            p.type == "mesh" ? "compiled meshes" : "octrees"),
                fmt::format("put `!xform` of the scene it was made from in its place, such as "
                            "`!xform -t 0 0 0 {:.40}.rad`",
                            stem));
  }
  const std::uint32_t modifier =
      modifiers_.find(placement.modifier.empty() ? p.modifier : placement.modifier, file, p);
  const RadianceLook& look = look_of(modifier);
  if (warned_.insert(modifier).second) warn_of(modifier, look, file, p);
  if (!look.is_drawn) return std::nullopt;
  const bool lights =
      look.emission == RadianceEmission::light || look.emission == RadianceEmission::illum;
  if (p.type == "source" || (lights && max_abs(look.radiance) > 0)) {
    is_repeatable = false;
    add_glowing(file, p, modifier, placement);
    return std::nullopt;
  }
  Use use{modifier};
  if (look.passes_per_length || look.material.refraction_index != 1) {
    const RadianceShape shape = radiance_shape(file, p, side_of(placement.is_inverted));
    use.is_inside_out = shape.faces_inward && shape.kind != RadianceShape::Kind::polygon &&
                        shape.kind != RadianceShape::Kind::ring;
    if (look.passes_per_length) {
      is_repeatable = false;
      const double scale = std::cbrt(std::abs(determinant(placement.map)));
      use.thickness = static_cast<double>(
          static_cast<float>(scale * mean_chord(shape).value_or(0) / modifiers_[modifier].scale));
    }
  }
  return material(use);
}

void RadianceBuilder::finish() {
  finish_polygons(scene_.shapes, std::move(polygons_));
  finish_lights(scene_, std::move(lights_), warnings_);
}

}  // namespace penumbra
