// SPDX-License-Identifier: MIT
// The modifiers of a Radiance scene by name: as in Radiance a name means what was last defined
// before, and a chain of modifiers leads from a surface to its material.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "penumbra/geometry/transform.h"
#include "penumbra/scene_io/radiance_file.h"

namespace penumbra {

/// A modifier where it is defined. Ids are indices; `none` is void.
/// What patterns multiply colours by, towards the sky and below the horizon.
struct RadianceBrightness {
  double above = 1, below = 1;
};

struct RadianceModifier {
  static constexpr std::uint32_t none = 0xFFFFFFFF;

  const RadianceFile* file = nullptr;
  const RadiancePrimitive* primitive = nullptr;  ///< of an alias: what it stands for
  std::uint32_t parent = none;                   ///< its own modifier
  std::uint32_t material = none;  ///< the material that the chain leads to: itself, if it is one
  std::uint32_t oddity = none;    ///< nearest texture, pattern or mixture on the way to it
  std::uint32_t other = none;     ///< the alternate material of a mirror or illum
  RadianceBrightness brightness;  ///< of its patterns
  Vec3d spot_direction;           ///< of a spotlight, in the world
  double scale = 1;               ///< of a dielectric: the world's length of one of the file's
};

/// What is known at one point of a scene.
class RadianceModifiers {
 public:
  /// A definition that was met, placed by `map` (a similarity). The same one met again in the same
  /// surroundings is the same id. Throws Error with its line for names that are not defined.
  void define(const RadianceFile& file, const RadiancePrimitive& primitive, const Transform& map);

  /// What `name` means now; none for void. Throws Error with the line of `user` where there is no
  /// such modifier.
  std::uint32_t find(const std::string& name, const RadianceFile& file,
                     const RadiancePrimitive& user) const;

  const RadianceModifier& operator[](std::uint32_t id) const { return all_[id]; }
  std::size_t size() const { return all_.size(); }

 private:
  std::optional<std::uint32_t> known(const std::string& name) const;
  std::uint32_t alias(const RadianceFile& file, const RadiancePrimitive& p) const;
  void complete(RadianceModifier& m, std::uint32_t id) const;

  using Key = std::tuple<const RadiancePrimitive*, std::uint32_t, std::uint32_t, double, double,
                         double, double>;

  std::vector<RadianceModifier> all_;
  std::unordered_map<std::string, std::uint32_t> names_;
  std::map<Key, std::uint32_t> ids_;
};

}  // namespace penumbra
