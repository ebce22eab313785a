// SPDX-License-Identifier: MIT
// pbrt-v4's scene files: blocks, and what is done once all is read.
#include "penumbra/scene_io/light_emitters.h"
#include "penumbra/scene_io/numbers.h"
#include "penumbra/scene_io/pbrt_camera.h"
#include "penumbra/scene_io/pbrt_lights.h"
#include "penumbra/scene_io/pbrt_materials.h"
#include "penumbra/scene_io/pbrt_parser.h"
#include "penumbra/scene_io/source.h"

#include <utility>

#include <fmt/format.h>

namespace penumbra {

void open_pbrt_block(PbrtParser& parser, std::string_view begin, PbrtPlace place) {
  constexpr std::size_t most_open = 4096;
  if (parser.saved.size() == most_open)
    throw Error(place, fmt::format("more than {} blocks in each other", most_open),
                "is an AttributeEnd missing?");
  parser.saved.push_back({begin, place, parser.pbrt.graphics});
}

PbrtSaved close_pbrt_block(PbrtParser& parser, std::string_view begin, std::string_view end,
                           PbrtPlace place) {
  if (parser.saved.empty())
    throw Error(place, fmt::format("{} without {}", end, begin), "take it out");
  PbrtSaved last = std::move(parser.saved.back());
  if (last.begin != begin)
    throw Error(
        place,
        fmt::format("{} where {} of line {} is still open", end, last.begin, last.place.line),
        "end the inner block first");
  parser.saved.pop_back();
  parser.pbrt.graphics = last.graphics;
  return last;
}

void parse_pbrt(PbrtParser& parser, PbrtTokens& tokens) {
  constexpr std::size_t most_materials = std::size_t{1} << 20;
  for (PbrtToken token = tokens.next(); token.kind != PbrtTokenKind::end; token = tokens.next()) {
    if (token.kind != PbrtTokenKind::word) fail_pbrt_token(token, "a directive such as Shape");
    PbrtDirective directive = find_pbrt_directive(token.text);
    if (!directive) directive = find_pbrt_transformation(token.text);
    if (!directive)
      throw Error(
          token.place, "unknown directive " + in_quotes(token.text),
          "pbrt-v4 does not have it; older scenes are brought up to date by pbrt --upgrade");
    directive(parser, tokens, token.place);
    if (parser.pbrt.materials.size() > most_materials)
      throw Error(token.place, fmt::format("more than {} materials", most_materials),
                  "name those that are the same with MakeNamedMaterial");
  }
}

namespace {

void check_all_is_closed(const PbrtParser& parser) {
  if (!parser.saved.empty())
    throw Error(parser.saved.back().place,
                fmt::format("{} is never ended", parser.saved.back().begin),
                "the file may be cut off");
}

void check_objects(const PbrtScene& pbrt) {
  for (const auto& [name, group] : pbrt.groups)
    if (!pbrt.group_is_defined[group])
      throw Error(pbrt.group_mentions[group], "there is no object " + in_quotes(name),
                  "define it between ObjectBegin and ObjectEnd");
}

bool is_empty(const ShapeSet& shapes) {
  return shapes.spheres.empty() && shapes.cones.empty() && shapes.rings.empty() &&
         shapes.meshes.empty() && shapes.instances.empty();
}

}  // namespace

Scene read_pbrt(const Source& source, Warnings& warnings) {
  PbrtScene pbrt(source, warnings);
  pbrt.scene.name = source.path.string();
  pbrt.scene.up = {0, 1, 0};
  pbrt.files.push_back(source.path.string());
  // What shapes are of that come before any material.
  pbrt.materials.emplace_back();
  pbrt.materials.back().definition = PbrtDefinition{"diffuse", {}};

  PbrtParser parser(pbrt);
  parser.known_files.insert(source.path.string());
  PbrtTokens tokens(pbrt.files.front(), source.bytes);
  parse_pbrt(parser, tokens);
  check_all_is_closed(parser);
  check_objects(pbrt);
  finish_pbrt_camera(pbrt);
  finish_pbrt_materials(pbrt);
  if (is_empty(pbrt.scene.shapes))
    throw Error({pbrt.scene.name, {}, {}}, "there are no shapes in the scene",
                "is this the scene's main file?");
  light_emitters(pbrt.scene, warnings);
  expose_pbrt(pbrt);
  pbrt.scene.wants_ground = !pbrt.scene.camera && pbrt.scene.lights.empty();
  return std::move(pbrt.scene);
}

}  // namespace penumbra
