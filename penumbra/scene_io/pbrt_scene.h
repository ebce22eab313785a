// SPDX-License-Identifier: MIT
// A pbrt-v4 scene as it is being read: what directives change, and what they add to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "penumbra/geometry/transform.h"
#include "penumbra/scene/scene.h"
#include "penumbra/scene_io/pbrt_params.h"
#include "penumbra/scene_io/source.h"

namespace penumbra {

/// What a directive makes: its kind ("sphere", "diffuse") and its parameters.
struct PbrtDefinition {
  std::string kind;
  PbrtParams params;
};

/// What AttributeBegin saves and AttributeEnd brings back.
struct PbrtGraphics {
  Transform to_world;       ///< pbrt's current transformation matrix
  bool moves_start = true;  ///< ActiveTransform: of transformations, those at the shutter's opening
  bool is_reversed = false;
  std::uint32_t material = 0;                        ///< index of a PbrtMaterialSlot
  std::shared_ptr<const PbrtDefinition> area_light;  ///< none: shapes do not glow
  // What Attribute gave.
  std::shared_ptr<const PbrtParams> shape_defaults, light_defaults, material_defaults,
      texture_defaults;
};

/// A material to be: shapes name it before it is known what it is, since pbrt looks names up at the
/// end. Its index is that of the material in the scene.
struct PbrtMaterialSlot {
  std::optional<PbrtDefinition> definition;
  std::string name;                   ///< of MakeNamedMaterial; else empty
  PbrtPlace mention;                  ///< the first
  std::optional<std::uint32_t> base;  ///< a glowing twin of that slot
  Color emission{};
  bool is_two_sided = false, casts_shadow = true;
};

/// Light from all around (LightSource "infinite"), and the rest of what the whole scene has one of.
struct PbrtSurroundings {
  Color radiance{};
  std::optional<PbrtPlace> place;
};

struct PbrtScene {
  PbrtScene(const Source& main_file, Warnings& heard) : source(main_file), warnings(heard) {}

  const Source& source;
  Warnings& warnings;
  Scene scene;
  std::deque<std::string> files;  ///< names for places

  PbrtGraphics graphics;
  std::map<std::string, Transform, std::less<>> coordinate_systems;

  std::vector<PbrtMaterialSlot> materials;
  std::map<std::string, std::uint32_t, std::less<>> named_materials;
  std::map<std::string, PbrtDefinition, std::less<>> color_textures, number_textures;

  std::optional<PbrtDefinition> camera, film;
  Transform camera_from_world;
  PbrtSurroundings surroundings;

  std::map<std::string, std::uint32_t, std::less<>> groups;
  std::vector<PbrtPlace> group_mentions;    ///< the first of each
  std::vector<bool> group_is_defined;       ///< by ObjectBegin
  std::optional<std::uint32_t> open_group;  ///< between ObjectBegin and ObjectEnd

  std::size_t corners_left = std::size_t{1} << 27;  ///< vertices and triangles of meshes
  std::size_t made_left = std::size_t{1} << 22;  ///< of them, those that no number in a file backs
  std::size_t repeated_left = std::size_t{1} << 24;  ///< those of mesh files that were read before
  std::set<std::string> mesh_files;
  std::set<std::string> unread;  ///< warnings about parameters
};

/// Warns of each parameter that nobody asked for, with the directive in front of its name.
void warn_unread(PbrtScene& pbrt, std::string_view directive, const PbrtDefinition& definition);

/// Whether a material of that kind is no surface, only the border of a medium.
bool is_pbrt_interface(std::string_view kind);

/// The shapes that a directive adds to: an open object's, or the scene's.
ShapeSet& pbrt_target(PbrtScene& pbrt);

}  // namespace penumbra
