// SPDX-License-Identifier: MIT
// The eight-wide hierarchy: nodes of eight boxes, leaves that are runs of what it holds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "penumbra/geometry/shape.h"
#include "penumbra/kernel/placement.h"
#include "penumbra/kernel/record.h"

namespace penumbra {

/// An inner node's index, a run of records, or a placement of another tree.
class NodeRef {
 public:
  static constexpr std::uint32_t most_records = 16;

  NodeRef() = default;
  static NodeRef inner(std::uint32_t node) { return NodeRef(node); }
  static NodeRef placement(std::uint32_t index) { return NodeRef(0x40000000u | index); }
  /// first < 2^27, 1 <= count <= most_records
  static NodeRef leaf(std::uint32_t first, std::uint32_t count) {
    return NodeRef(0x80000000u | (count - 1) << 27 | first);
  }
  bool is_leaf() const { return bits_ >> 31; }
  bool is_placement() const { return bits_ >> 30 == 1; }
  std::uint32_t node() const { return bits_; }
  std::uint32_t placed() const { return bits_ & 0x3fffffffu; }
  std::uint32_t first() const { return bits_ & 0x7ffffffu; }
  std::uint32_t count() const { return (bits_ >> 27 & 15) + 1; }

 private:
  explicit NodeRef(std::uint32_t bits) : bits_(bits) {}
  std::uint32_t bits_;  // trivial: traversal stacks must not be cleared for each ray
};

/// Boxes of up to eight children, one array a plane; the used ones come first.
struct alignas(64) WideNode {
  static constexpr int width = 8;
  float lo[3][width] = {};
  float hi[3][width] = {};
  NodeRef child[width] = {};
  std::uint32_t used = 0;  ///< bit mask of the children
};

/// The builder's limit. Leaves with placements become nodes: one level more. What a traversal's
/// stack can hold follows from it.
inline constexpr int most_levels = 64;
inline constexpr int stack_size = (most_levels + 1) * WideNode::width;

/// A hierarchy over boxes: (1) every box lies in exactly one leaf; (2) every node's box holds the
/// boxes below it exactly; (3) the same boxes give the same tree, whatever the number of threads.
struct BoxTree {
  std::vector<WideNode> nodes;       ///< the first is the root; empty when there are no boxes
  std::vector<std::uint32_t> order;  ///< the boxes in leaf order: leaves are runs of this
};

/// Surface area heuristic by Embree's builder (`rtcBuildBVH`, high quality). Throws
/// std::runtime_error when Embree cannot be had, std::length_error for 2^27 boxes and more. Up to
/// `tested_together` boxes of a leaf cost as much as one. Cost: O(n log n) over all cores.
BoxTree build_box_tree(std::span<const Box> boxes, std::uint32_t tested_together = 1);

/// A hierarchy over records (`bounds(Record)`), which lie in leaf order, and over placements of the
/// groups, which have trees of their own and no placements.
struct WideTree {
  std::vector<WideNode> nodes;
  std::vector<Record> records;
  std::vector<WideTree> groups;
  std::vector<Placement> placements;  ///< by rising `first`
  std::size_t memory_bytes() const;
};

/// `groups` (which hold something) and `placements` as in WideTree. At most 2^27 records and
/// placements.
WideTree build_wide_tree(const std::vector<Record>& records, std::vector<WideTree> groups = {},
                         std::vector<Placement> placements = {});

/// After records (other boxes, the same count) or groups have changed in place: fits all boxes to
/// them, bottom-up; the tree keeps its shape. Placements are made anew by the caller. Cost: linear.
void refit_boxes(WideTree& tree);

/// Box of one child.
inline Box box_of(const WideNode& node, int child) {
  return {{node.lo[0][child], node.lo[1][child], node.lo[2][child]},
          {node.hi[0][child], node.hi[1][child], node.hi[2][child]}};
}

/// Box of all children.
Box bounds(const WideNode& node);

}  // namespace penumbra
