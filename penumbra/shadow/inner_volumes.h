// SPDX-License-Identifier: MIT
// Umbra behind meshes: inner offsets of what they enclose (paper, section 3, Lemma 3, Eq. 8, which
// left meshes open).
//
// Let a volume be enclosed by triangles S and fills F of their holes, and the light lie outside of
// both. A segment from p to a sample that passes through the volume crosses S or F on its way from
// there to the light. Where the shaft from p to the light misses F it crosses S: blocked, wherever
// p is. The crossing is there for the intersector, too, if volume and light keep off S and F by
// more than its errors: these move the surface, but open no gap in it, since triangles that share
// corners are watertight.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "penumbra/geometry/mesh_solids.h"
#include "penumbra/geometry/shape.h"
#include "penumbra/kernel/wide_tree.h"
#include "penumbra/shadow/light_hull.h"

namespace penumbra {

inline constexpr std::uint32_t no_volume = 0xffffffffu;

/// What a query found, and what it cost.
struct VolumeAnswer {
  std::uint32_t volume = no_volume;  ///< the one that proves umbra
  std::uint32_t tests = 0;           ///< volumes tested
};

class InnerVolumes {
 public:
  InnerVolumes() = default;

  /// Of the meshes' triangles that cast shadows (`casts_no_shadow` by surface, as in
  /// KernelOptions). Cost: as `mesh_solids`, and linear in the triangles for each light.
  InnerVolumes(const ShapeSet& shapes, const std::vector<bool>& casts_no_shadow,
               std::span<const LightHull> lights, const MeshSolidOptions& options = {});

  /// A volume is found only if every sample of the light (the `light`-th, whose hull this is) is
  /// blocked as seen from p: proven, with the intersector's errors. Which one it is depends on
  /// `first`, which is tried first (the one that proved umbra last, or `no_volume`); whether there
  /// is one doesn't. Cost: that of `body_covers` for each volume near the segment to the centre.
  VolumeAnswer covering(std::uint32_t light, const LightHull& hull, Vec3f p,
                        std::uint32_t first) const;

  std::size_t size() const { return volumes_.size(); }
  std::size_t memory_bytes() const;

 private:
  /// A run of fills that lie near one another.
  struct FillGroup {
    Box box;
    std::vector<FlatTriangle> fills;
  };
  struct Solid {
    Box box;
    std::vector<FillGroup> fills;
    std::vector<double> clearance;  // of each light, see light_clearance.h
  };
  struct Volume {
    InnerVolume inner;
    std::uint32_t solid;
  };
  void add(MeshSolid solid, std::span<const LightHull> lights);
  struct Query;
  bool covers(const Volume& volume, const Query& query) const;

  std::vector<Solid> solids_;
  std::vector<Volume> volumes_;  // in the order of the hierarchy
  std::vector<WideNode> nodes_;
};

}  // namespace penumbra
