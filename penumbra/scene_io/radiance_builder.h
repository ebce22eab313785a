// SPDX-License-Identifier: MIT
// Goes through Radiance scene files in order and puts what they say into a scene: commands are
// carried out, names looked up, surfaces placed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "penumbra/scene/scene.h"
#include "penumbra/scene_io/radiance_commands.h"
#include "penumbra/scene_io/radiance_include.h"
#include "penumbra/scene_io/radiance_lights.h"
#include "penumbra/scene_io/radiance_materials.h"
#include "penumbra/scene_io/radiance_modifiers.h"
#include "penumbra/scene_io/radiance_shapes.h"

namespace penumbra {

/// How a file's surfaces come into the scene.
struct RadiancePlacement {
  Transform map;
  bool is_inverted = false;
  std::string modifier;  ///< instead of the surfaces' own; empty: none
};

/// Surfaces of the scene's own files go into the scene as they are. Those of other files become a
/// group, placed as often as the file is: one for each set of materials that its names lead to.
/// What lights the scene is always placed one by one. Expansion is bounded: 2^24 statements of
/// files that were read before, 2^19 placements, 64 files one inside the other.
class RadianceBuilder {
 public:
  RadianceBuilder(Scene& scene, Warnings& warnings, std::filesystem::path main);

  RadianceLibrary& library() { return library_; }
  /// Throws Error.
  void read_main(const RadianceFile& file);
  /// After all files.
  void finish();

 private:
  /// A command, read once.
  struct Command {
    std::vector<const RadianceFile*> files;
    std::vector<RadiancePlacement> placements;
  };
  /// A surface of a file's own and the material that its name leads to.
  struct Surface {
    const RadiancePrimitive* primitive = nullptr;
    std::uint32_t surface = 0;
  };
  /// How a material is used.
  struct Use {
    std::uint32_t modifier = RadianceModifier::none;
    bool is_inside_out = false;
    bool casts_shadow = true;
    double thickness = 0;  ///< of what absorbs; 0: not known
    auto operator<=>(const Use&) const = default;
  };
  using Surfaces = std::vector<Surface>;

  /// The group that the file has become, where it can be placed again without another look.
  std::optional<std::uint32_t> read(const RadianceFile& file, const RadiancePlacement& placement);
  Surfaces read_statements(const RadianceFile& file, const RadiancePlacement& placement,
                           bool& is_repeatable);
  void run(const RadianceFile& file, const RadiancePrimitive& command,
           const RadiancePlacement& placement);
  const Command& parsed(const RadianceFile& file, const RadiancePrimitive& command);
  void parse(const RadianceFile& file, const RadiancePrimitive& command, Command& result);

  /// Its material's index; nothing where it is no part of the file's group.
  std::optional<std::uint32_t> read_surface(const RadianceFile& file, const RadiancePrimitive& p,
                                            const RadiancePlacement& placement,
                                            bool& is_repeatable);
  void add_glowing(const RadianceFile& file, const RadiancePrimitive& p, std::uint32_t modifier,
                   const RadiancePlacement& placement);
  void add_light(const RadianceFile& file, const RadiancePrimitive& p, std::uint32_t modifier,
                 const RadianceShape& shape);
  std::uint32_t group_of(const RadianceFile& file, const Surfaces& surfaces, bool is_inverted);
  void add_shapes(ShapeSet& shapes, Mesh& polygons, const RadianceFile& file,
                  const Surfaces& surfaces, bool is_inverted);

  const RadianceLook& look_of(std::uint32_t modifier);
  std::uint32_t material(const Use& use);
  std::uint32_t glowing_material(std::uint32_t modifier);
  /// A material that glows but lights nothing by itself, since a light is there for it.
  std::uint32_t seen_material(std::uint32_t modifier);
  /// What its material is not drawn with, once a material.
  void warn_of(std::uint32_t modifier, const RadianceLook& look, const RadianceFile& file,
               const RadiancePrimitive& p);
  void warn(const std::string& kind, const RadianceFile& file, std::size_t line);
  void spend(std::size_t statements, const RadianceFile& file);

  Scene& scene_;
  Warnings& warnings_;
  std::filesystem::path main_;
  RadianceLibrary library_;
  RadianceModifiers modifiers_;
  RadianceLights lights_;
  Mesh polygons_;  ///< of the scene's own files
  std::vector<const RadianceFile*> open_;
  std::map<const RadiancePrimitive*, Command> commands_;
  std::map<std::uint32_t, RadianceLook> looks_;
  std::map<Use, std::uint32_t> materials_;
  std::map<std::uint32_t, std::uint32_t> glowing_, seen_;
  std::map<std::tuple<const RadianceFile*, bool, std::vector<std::uint32_t>>, std::uint32_t>
      groups_;
  std::map<std::string, std::string> kinds_;
  std::set<std::uint32_t> warned_;
  std::set<const RadianceFile*> known_, grouped_;  ///< read before; become a group before
  std::size_t statements_left_ = std::size_t{1} << 24;
};

}  // namespace penumbra
