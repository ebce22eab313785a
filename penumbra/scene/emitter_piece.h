// SPDX-License-Identifier: MIT
// Private to the layer: what of glowing surfaces is to become one light.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "penumbra/geometry/light_shape.h"
#include "penumbra/scene/far_field.h"
#include "penumbra/scene/glowing_surface.h"
#include "penumbra/scene/light.h"

namespace penumbra {

/// front: on one side of a plane, `axis` its normal; both: flat, on its two sides; around: a solid.
enum class Shines { front, both, around };

struct EmitterPiece {
  std::vector<Vec3f> points;  ///< the light is their hull
  Shines shines = Shines::around;
  Vec3d axis;                     ///< unit, or 0 where it has none
  Vec3d power;                    ///< over pi: radiance times area of what shines from one side
  Vec3d center;                   ///< of the surface
  std::optional<BallLight> ball;  ///< where the surface is one
  FarField field{};               ///< what its triangles send, of the power above
  bool is_joined = false;         ///< made of several pieces
  std::size_t surface = 0;        ///< index of what it is a piece of
};

/// The triangles as one piece of a surface, of this power. One-sided ones shine to the front where
/// their normals, on the whole, have one.
EmitterPiece piece_of(std::span<const GlowingTriangle> triangles, Sides sides, Vec3d power);

/// A light of this shape and the piece's power. It shines to the front alone where the piece does.
Light with_power(LightShape shape, const EmitterPiece& piece);

/// The light of a piece: ball, parallelogram, disk (of regular polygons of 16 and more corners),
/// polygon of at most `most_corners` and 16, or hull of at most so many; a line, ball or none where
/// these would be too thin for what `problem_of` asks. Its power is the piece's.
std::optional<Light> light_of(const EmitterPiece& piece, std::size_t most_corners);

}  // namespace penumbra
