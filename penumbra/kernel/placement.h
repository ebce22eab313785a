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
  Box box{};                ///< holds the boxes of all its records in the world
  // What nodes' boxes are mapped by (space-inl.h): the map in float, and what float loses of a
  // coordinate of the group.
  float matrix[3][3] = {}, offset[3] = {}, pad[3] = {};
};

/// `root` is that of the group's tree. Maps need not be similarities if its records are triangles.
/// Nodes need numbers in float's range: the largest entry of each row is from 1e-15 to 1e15.
Placement make_placement(const Transform& map, const WideNode& root, std::uint32_t group,
                         std::uint32_t first);

/// The record in the world; rounded to float once a number. Triangles keep the order of their
/// corners. Its id is that of the group's record + `first`.
Record placed(const Record& record, const Placement& placement);

}  // namespace penumbra
