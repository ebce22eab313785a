// SPDX-License-Identifier: MIT
// What read_nff knows while it goes through a file, and the "#! " comments that change it.
// NFF cannot say all that a Scene holds. Comments are free, so ours carry the rest; other programs
// read past them. After "#! ":
//   light <words>             a light as in light_spec.h, beside the file's `l`
//   radius r                  the light before it is a ball
//   intensity r g b           linear intensity of the light before it, in place of its colour
//   falloff inverse_square    of the light before it
//   beam <words>              of the light before it: ax ay az full_deg none_deg, see light_spec.h
//   background r g b | none   linear, or left to whoever draws
//   ambient r g b             linear; 0.1 in a file without it
//   up x y z                  which way is up
//   parallel height           the view before it has parallel rays, its picture this height
//   window left top right bottom  the part of the whole picture that the view before it shows
//   ground                    wants a ground put under it
//   material <key value ...>  changes the current `f`; the keys are Material's members, linear
//                             colours, `name` last and to the end of the line
//   backdrop                  the next polygon is a backdrop, a mesh of its own
//   mesh [backdrop]           the polygons from here on are a mesh of their own
//   capped                    the next `c` has caps
//   ring nx ny nz             the next `c`, whose two centres are equal, is a ring facing this way
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "penumbra/scene/scene.h"
#include "penumbra/scene_io/source.h"
#include "penumbra/scene_io/tokens.h"

namespace penumbra {

struct NffState {
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  Scene scene;
  std::vector<bool> light_has_intensity;  ///< a light; the others share what is right for so many

  bool has_fill = false;                 ///< an `f` was read
  Material material;                     ///< of the last `f`, and of what directives made of it
  std::optional<std::uint32_t> surface;  ///< its index, once it is one of the scene's
  std::map<std::string, std::uint32_t> surfaces_by_bits;

  std::size_t flat_mesh = none;    ///< which mesh takes the next `p`; none: a new one
  std::size_t smooth_mesh = none;  ///< the same for `pp`
  bool mesh_is_backdrop = false;   ///< both of them

  bool has_up = false;  ///< an `up` directive was read; else the view's counts

  // Of the next entity alone.
  Caps next_caps = Caps::open;
  std::optional<Vec3f> next_ring_normal;
  bool next_is_backdrop = false;
};

/// Index of the current material, which joins the scene unless an equal one is there already.
std::uint32_t current_surface(NffState& state);

/// Carries out a "#! " comment. Throws Error; one that is not known is only warned of.
void apply_directive(NffState& state, const Token& directive, const std::string& file,
                     Warnings& warnings);

}  // namespace penumbra
