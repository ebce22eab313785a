// SPDX-License-Identifier: MIT
// Instances: a tree that stands in the world in more than one place. Its boxes and records are
// mapped when a traversal comes to them, so that everything behind, the one intersector and all
// proofs, deals with nodes and records of the world, and knows nothing of instances.
#pragma once

#include <cstdint>

#include "penumbra/geometry/box.h"
#include "penumbra/geometry/transform.h"
#include "penumbra/kernel/record.h"

namespace penumbra {

struct WideNode;

/// Where one instance stands.
struct Placement {
  Transform map;
  double scale = 0;         ///< of a similarity: what it multiplies radii by
  std::uint32_t group = 0;  ///< whose tree it is, an index into WideTree::groups
  std::uint32_t first = 0;  ///< id of its first primitive, and index of its first record
  // What boxes are mapped by: the map in float, its numbers' sizes, and what float loses of a
  // coordinate of the group.
  float matrix[3][3] = {}, size[3][3] = {}, offset[3] = {}, pad[3] = {};
};

/// `group_box` holds the group's records. Maps need not be similarities if these are triangles.
/// Nodes need numbers in float's range: the largest entry of each row is from 1e-15 to 1e15.
Placement make_placement(const Transform& map, const Box& group_box, std::uint32_t group,
                         std::uint32_t first);

/// The record in the world; rounded to float once a number. Triangles keep the order of their
/// corners. Its id is that of the group's record + `first`.
Record placed(const Record& record, const Placement& placement);

/// The node with boxes that hold, in the world, what its boxes hold in the group: the boxes of all
/// placed records below. Cost: 20 ns.
WideNode placed(const WideNode& node, const Placement& placement);

}  // namespace penumbra
