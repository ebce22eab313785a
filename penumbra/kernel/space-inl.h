// SPDX-License-Identifier: MIT
// A tree as a traversal sees it: nodes and leaves in the world. The tree itself has them so;
// those of a placement are mapped into the room that the traversal brings.
//
// Highway "inl" header: included once for each instruction set.

#if defined(PENUMBRA_KERNEL_SPACE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PENUMBRA_KERNEL_SPACE_INL_H_
#undef PENUMBRA_KERNEL_SPACE_INL_H_
#else
#define PENUMBRA_KERNEL_SPACE_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "penumbra/kernel/wide_tree.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The node with boxes that hold, in the world, what its boxes hold in the group: the boxes of all
/// placed records below.
HWY_INLINE void place(const WideNode& node, const Placement& placement, WideNode& out) {
  const hn::CappedTag<float, WideNode::width> d;
  const auto half = hn::Set(d, 0.5f);
  for (std::size_t i = 0; i < WideNode::width; i += hn::Lanes(d)) {
    hn::Vec<decltype(d)> center[3], reach[3];
    for (int axis = 0; axis < 3; ++axis) {
      const auto lo = hn::Load(d, node.lo[axis] + i), hi = hn::Load(d, node.hi[axis] + i);
      center[axis] = hn::Mul(half, hn::Add(lo, hi));
      reach[axis] = hn::Mul(half, hn::Sub(hi, lo));
    }
    for (int row = 0; row < 3; ++row) {
      auto middle = hn::Set(d, placement.offset[row]), extent = hn::Set(d, placement.pad[row]);
      for (int axis = 0; axis < 3; ++axis) {
        const auto entry = hn::Set(d, placement.matrix[row][axis]);
        middle = hn::Add(middle, hn::Mul(entry, center[axis]));
        extent = hn::Add(extent, hn::Mul(hn::Abs(entry), reach[axis]));
      }
      hn::Store(hn::Sub(middle, extent), d, out.lo[row] + i);
      hn::Store(hn::Add(middle, extent), d, out.hi[row] + i);
    }
  }
  std::copy(node.child, node.child + WideNode::width, out.child);
  out.used = node.used;
}

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
    place(tree.nodes[ref.node()], placement, room.node);
    return room.node;
  }
  std::span<const Record> records(NodeRef leaf, Room& room) const {
    for (std::uint32_t i = 0; i < leaf.count(); ++i)
      room.records[i] = placed(tree.records[leaf.first() + i], placement);
    return {room.records.data(), leaf.count()};
  }
  std::uint32_t first(NodeRef leaf) const { return placement.first + leaf.first(); }
};

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include once for each instruction set
