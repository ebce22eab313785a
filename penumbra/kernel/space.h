// SPDX-License-Identifier: MIT
// A tree as a traversal sees it: nodes and leaves in the world. The tree itself has them so;
// those of a placement are mapped into the room that the traversal brings.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "penumbra/kernel/wide_tree.h"

namespace penumbra {

/// The whole tree; its placements are for the traversal to enter.
struct WholeTree {
  static constexpr bool has_placements = true;
  struct Room {};
  const WideTree& tree;

  const WideNode& node(NodeRef ref, Room&) const { return tree.nodes[ref.node()]; }
  std::span<const Record> records(NodeRef leaf, Room&) const {
    return {&tree.records[leaf.first()], leaf.count()};
  }
  std::uint32_t first(NodeRef leaf) const { return leaf.first(); }
};

/// The tree of a placement.
struct PlacedTree {
  static constexpr bool has_placements = false;
  struct Room {
    WideNode node;
    std::array<Record, NodeRef::most_records> records;
  };
  const WideTree& tree;
  const Placement& placement;

  PlacedTree(const WideTree& whole, NodeRef ref)
      : PlacedTree(whole, whole.placements[ref.placed()]) {}
  PlacedTree(const WideTree& whole, const Placement& placed_)
      : tree(whole.groups[placed_.group]), placement(placed_) {}

  const WideNode& node(NodeRef ref, Room& room) const {
    return room.node = placed(tree.nodes[ref.node()], placement);
  }
  std::span<const Record> records(NodeRef leaf, Room& room) const {
    for (std::uint32_t i = 0; i < leaf.count(); ++i)
      room.records[i] = placed(tree.records[leaf.first() + i], placement);
    return {room.records.data(), leaf.count()};
  }
  std::uint32_t first(NodeRef leaf) const { return placement.first + leaf.first(); }
};

}  // namespace penumbra
