// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "penumbra/scene_io/numbers.h"
#include "penumbra/scene_io/pbrt_lights.h"
#include "penumbra/scene_io/pbrt_materials.h"
#include "penumbra/scene_io/pbrt_parser.h"
#include "penumbra/scene_io/pbrt_shapes.h"
#include "penumbra/scene_io/texture_io.h"

namespace penumbra {
namespace {

constexpr const char* a_kind = "a kind in quotation marks";
constexpr const char* a_name = "a name in quotation marks";

PbrtDefinition read_definition(PbrtTokens& tokens, PbrtPlace place,
                               const std::shared_ptr<const PbrtParams>& defaults = {}) {
  std::string kind = tokens.text(a_kind);
  PbrtDefinition definition{std::move(kind), PbrtParams::read(tokens, place)};
  definition.params.set_defaults(defaults);
  return definition;
}

void attribute_begin(PbrtParser& parser, PbrtTokens&, PbrtPlace place) {
  open_pbrt_block(parser, "AttributeBegin", place);
}

void attribute_end(PbrtParser& parser, PbrtTokens&, PbrtPlace place) {
  close_pbrt_block(parser, "AttributeBegin", "AttributeEnd", place);
}

void attribute(PbrtParser& parser, PbrtTokens& tokens, PbrtPlace place) {
  const std::string target = tokens.text(a_kind);
  const PbrtParams params = PbrtParams::read(tokens, place);
  PbrtGraphics& g = parser.pbrt.graphics;
  const auto add = [&](std::shared_ptr<const PbrtParams>& defaults) {
    defaults = std::make_shared<const PbrtParams>(params.with_defaults(defaults.get()));
  };
  if (target == "shape")
    add(g.shape_defaults);
  else if (target == "light")
    add(g.light_defaults);
  else if (target == "material")
    add(g.material_defaults);
  else if (target == "texture")
    add(g.texture_defaults);
  else if (target != "medium")
    throw Error(place, "Attribute of unknown things " + in_quotes(target),
                "pbrt-v4 has shape, light, material, medium and texture");
}

/// Index of the group of that name, begun or not yet.
std::uint32_t group_of(PbrtScene& pbrt, const std::string& name, PbrtPlace place) {
  const auto index = static_cast<std::uint32_t>(pbrt.scene.shapes.groups.size());
  const auto [known, is_new] = pbrt.groups.try_emplace(name, index);
  if (is_new) {
    pbrt.scene.shapes.groups.emplace_back();
    pbrt.group_mentions.push_back(place);
    pbrt.group_is_defined.push_back(false);
  }
  return known->second;
}

void object_begin(PbrtParser& parser, PbrtTokens& tokens, PbrtPlace place) {
  PbrtScene& pbrt = parser.pbrt;
  const std::string name = tokens.text(a_name);
  if (pbrt.open_group)
    throw Error(place, "ObjectBegin inside an object", "end the other with ObjectEnd");
  open_pbrt_block(parser, "ObjectBegin", place);
  const std::uint32_t group = group_of(pbrt, name, place);
  if (pbrt.group_is_defined[group])
    throw Error(place, "object " + in_quotes(name) + " is defined twice", "give it another name");
  pbrt.group_is_defined[group] = true;
  pbrt.open_group = group;
}

void object_end(PbrtParser& parser, PbrtTokens&, PbrtPlace place) {
  close_pbrt_block(parser, "ObjectBegin", "ObjectEnd", place);
  parser.pbrt.open_group.reset();
}

void object_instance(PbrtParser& parser, PbrtTokens& tokens, PbrtPlace place) {
  constexpr std::size_t most_instances = std::size_t{1} << 24;
  PbrtScene& pbrt = parser.pbrt;
  const std::string name = tokens.text(a_name);
  if (pbrt.open_group)
    throw Error(place, "ObjectInstance inside an object", "objects cannot hold others in pbrt");
  std::vector<Instance>& instances = pbrt.scene.shapes.instances;
  if (instances.size() == most_instances)
    throw Error(place, "more than 16 million instances", "split the scene");
  instances.push_back({group_of(pbrt, name, place), pbrt.graphics.to_world});
}

/// A file named by Include or Import, beside the scene's main file as in pbrt.
void read_file(PbrtParser& parser, PbrtTokens& tokens, PbrtPlace place) {
  constexpr std::size_t most_deep = 32, most_files = 10000;
  constexpr std::size_t most_repeated_bytes = std::size_t{64} << 20;
  PbrtScene& pbrt = parser.pbrt;
  const std::string name = tokens.text(a_name);
  const auto path = find_beside(pbrt.source.path, name);
  if (!path)
    throw Error(place, "there is no file " + in_quotes(name),
                "put it beside the scene's main file");
  if (++parser.files > most_files || parser.files_deep == most_deep)
    throw Error(
        place,
        fmt::format("more than {} files are included, or {} in each other", most_files, most_deep),
        "does a file include itself?");
  const Source source = load(*path);
  if (!parser.known_files.insert(path->string()).second)
    parser.repeated_bytes += source.bytes.size();
  if (parser.repeated_bytes > most_repeated_bytes)
    throw Error(place, "the same files are included again and again",
                "use ObjectBegin and ObjectInstance");
  pbrt.files.push_back(path->string());
  PbrtTokens included(pbrt.files.back(), source.bytes);
  ++parser.files_deep;
  parse_pbrt(parser, included);
  --parser.files_deep;
}

/// Import leaves the graphics state as it was.
void import_file(PbrtParser& parser, PbrtTokens& tokens, PbrtPlace place) {
  const PbrtGraphics graphics = parser.pbrt.graphics;
  read_file(parser, tokens, place);
  parser.pbrt.graphics = graphics;
}

void world_begin(PbrtParser& parser, PbrtTokens&, PbrtPlace) {
  parser.pbrt.graphics.to_world = {};
  parser.pbrt.graphics.moves_start = true;
  parser.pbrt.coordinate_systems.insert_or_assign("world", Transform{});
}

/// pbrt-v4 has none.
void world_end(PbrtParser&, PbrtTokens&, PbrtPlace place) {
  throw Error(place, "WorldEnd: this is a scene of pbrt-v3",
              "convert it: pbrt --upgrade old.pbrt > new.pbrt");
}

/// How pbrt goes about it: nothing of the scene.
void skip_definition(PbrtParser&, PbrtTokens& tokens, PbrtPlace place) {
  read_definition(tokens, place);
}

/// A name and one value, of whatever kind.
void option(PbrtParser&, PbrtTokens& tokens, PbrtPlace) {
  tokens.text(a_name);
  const PbrtToken value = tokens.next();
  if (value.kind != PbrtTokenKind::word && value.kind != PbrtTokenKind::text)
    fail_pbrt_token(value, "the value of an option");
}

void color_space(PbrtParser& parser, PbrtTokens& tokens, PbrtPlace place) {
  if (tokens.text(a_name) != "srgb")
    parser.pbrt.warnings.add("colours are taken as sRGB's, whatever ColorSpace says", place);
}

void camera(PbrtParser& parser, PbrtTokens& tokens, PbrtPlace place) {
  PbrtScene& pbrt = parser.pbrt;
  pbrt.camera = read_definition(tokens, place);
  pbrt.camera_from_world = pbrt.graphics.to_world;
  if (const auto world = inverse(pbrt.graphics.to_world))
    pbrt.coordinate_systems.insert_or_assign("camera", *world);
}

void film(PbrtParser& parser, PbrtTokens& tokens, PbrtPlace place) {
  parser.pbrt.film = read_definition(tokens, place);
}

void shape(PbrtParser& parser, PbrtTokens& tokens, PbrtPlace place) {
  PbrtScene& pbrt = parser.pbrt;
  add_pbrt_shape(pbrt, read_definition(tokens, place, pbrt.graphics.shape_defaults));
}

void light_source(PbrtParser& parser, PbrtTokens& tokens, PbrtPlace place) {
  PbrtScene& pbrt = parser.pbrt;
  add_pbrt_light(pbrt, read_definition(tokens, place, pbrt.graphics.light_defaults));
}

void area_light_source(PbrtParser& parser, PbrtTokens& tokens, PbrtPlace place) {
  PbrtGraphics& graphics = parser.pbrt.graphics;
  graphics.area_light = std::make_shared<const PbrtDefinition>(
      read_definition(tokens, place, graphics.light_defaults));
}

void material(PbrtParser& parser, PbrtTokens& tokens, PbrtPlace place) {
  PbrtGraphics& graphics = parser.pbrt.graphics;
  graphics.material =
      add_pbrt_material(parser.pbrt, read_definition(tokens, place, graphics.material_defaults));
}

void make_named_material(PbrtParser& parser, PbrtTokens& tokens, PbrtPlace place) {
  PbrtScene& pbrt = parser.pbrt;
  const std::string name = tokens.text(a_name);
  PbrtParams params = PbrtParams::read(tokens, place);
  params.set_defaults(pbrt.graphics.material_defaults);
  if (!params.has("type"))
    throw Error(place, "material " + in_quotes(name) + " has no \"string type\"",
                "give it one, such as \"diffuse\"");
  const std::string kind = params.text("type", "");
  PbrtMaterialSlot& slot = pbrt.materials[named_pbrt_material(pbrt, name, place)];
  if (slot.definition)
    throw Error(place, "material " + in_quotes(name) + " is defined twice", "give it another name");
  slot.definition = PbrtDefinition{kind, std::move(params)};
}

void named_material(PbrtParser& parser, PbrtTokens& tokens, PbrtPlace place) {
  const std::string name = tokens.text(a_name);
  parser.pbrt.graphics.material = named_pbrt_material(parser.pbrt, name, place);
}

void texture(PbrtParser& parser, PbrtTokens& tokens, PbrtPlace place) {
  PbrtScene& pbrt = parser.pbrt;
  const std::string name = tokens.text(a_name), type = tokens.text("float or spectrum");
  if (type != "float" && type != "spectrum" && type != "color" && type != "rgb")
    throw Error(place, "a texture of " + in_quotes(type), "pbrt-v4 has float and spectrum");
  PbrtDefinition definition = read_definition(tokens, place, pbrt.graphics.texture_defaults);
  auto& textures = type == "float" ? pbrt.number_textures : pbrt.color_textures;
  const auto [known, is_new] = textures.insert_or_assign(name, std::move(definition));
  if (!is_new) pbrt.warnings.add("a texture is defined twice; the last one counts", place);
}

constexpr const char* no_media = "media (fog, smoke) are not drawn";

void medium(PbrtParser& parser, PbrtTokens& tokens, PbrtPlace place) {
  tokens.text(a_name);
  PbrtParams::read(tokens, place);
  parser.pbrt.warnings.add(no_media, place);
}

/// One name is for both sides.
void medium_interface(PbrtParser& parser, PbrtTokens& tokens, PbrtPlace place) {
  tokens.text(a_name);
  if (tokens.peek().kind == PbrtTokenKind::text) tokens.next();
  parser.pbrt.warnings.add(no_media, place);
}

struct Entry {
  std::string_view name;
  PbrtDirective read;
};

constexpr Entry directives[] = {{"AttributeBegin", attribute_begin},
                                {"AttributeEnd", attribute_end},
                                {"Attribute", attribute},
                                {"ObjectBegin", object_begin},
                                {"ObjectEnd", object_end},
                                {"ObjectInstance", object_instance},
                                {"Include", read_file},
                                {"Import", import_file},
                                {"WorldBegin", world_begin},
                                {"WorldEnd", world_end},
                                {"Option", option},
                                {"ColorSpace", color_space},
                                {"Camera", camera},
                                {"Film", film},
                                {"Sampler", skip_definition},
                                {"PixelFilter", skip_definition},
                                {"Integrator", skip_definition},
                                {"Accelerator", skip_definition},
                                {"Shape", shape},
                                {"LightSource", light_source},
                                {"AreaLightSource", area_light_source},
                                {"Material", material},
                                {"MakeNamedMaterial", make_named_material},
                                {"NamedMaterial", named_material},
                                {"Texture", texture},
                                {"MakeNamedMedium", medium},
                                {"MediumInterface", medium_interface}};

}  // namespace

PbrtDirective find_pbrt_directive(std::string_view name) {
  const auto found = std::find_if(std::begin(directives), std::end(directives),
                                  [&](const Entry& entry) { return entry.name == name; });
  return found == std::end(directives) ? nullptr : found->read;
}

}  // namespace penumbra
