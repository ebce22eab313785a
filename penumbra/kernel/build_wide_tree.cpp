// SPDX-License-Identifier: MIT
#include <embree3/rtcore.h>

#include <algorithm>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>

#include "penumbra/kernel/wide_tree.h"

namespace penumbra {
namespace {

// What Embree's builder makes, in its own arena: a node with children, or a leaf.
struct BuiltNode {
  unsigned children = 0;  // 0: a leaf
  BuiltNode* child[WideNode::width] = {};
  RTCBounds box[WideNode::width] = {};
  unsigned records = 0;
  unsigned record[NodeRef::most_records] = {};
};

void* create_node(RTCThreadLocalAllocator arena, unsigned children, void*) {
  auto* node = new (rtcThreadLocalAlloc(arena, sizeof(BuiltNode), 16)) BuiltNode;
  node->children = children;
  return node;
}

void set_children(void* node, void** children, unsigned count, void*) {
  for (unsigned i = 0; i < count; ++i)
    static_cast<BuiltNode*>(node)->child[i] = static_cast<BuiltNode*>(children[i]);
}

void set_boxes(void* node, const RTCBounds** boxes, unsigned count, void*) {
  for (unsigned i = 0; i < count; ++i) static_cast<BuiltNode*>(node)->box[i] = *boxes[i];
}

void* create_leaf(RTCThreadLocalAllocator arena, const RTCBuildPrimitive* primitives,
                  std::size_t count, void*) {
  auto* leaf = new (rtcThreadLocalAlloc(arena, sizeof(BuiltNode), 16)) BuiltNode;
  leaf->records = static_cast<unsigned>(count);
  for (unsigned i = 0; i < count; ++i) leaf->record[i] = primitives[i].primID;
  std::sort(leaf->record, leaf->record + count);  // builder threads must not decide the order
  return leaf;
}

RTCBuildPrimitive build_primitive(const Box& b, unsigned index) {
  return {b.lo.x, b.lo.y, b.lo.z, 0, b.hi.x, b.hi.y, b.hi.z, index};
}

/// Embree's tree -> ours, depth first.
class Flattener {
 public:
  explicit Flattener(BoxTree& tree) : tree_(tree) {}

  NodeRef add(const BuiltNode& built) {
    if (built.children == 0) return add_leaf(built);
    const std::size_t index = tree_.nodes.size();
    tree_.nodes.emplace_back();
    WideNode node;
    for (unsigned i = 0; i < built.children; ++i) {
      node.child[i] = add(*built.child[i]);
      set_box(node, i, built.box[i]);
    }
    tree_.nodes[index] = node;
    return NodeRef::inner(static_cast<std::uint32_t>(index));
  }

  NodeRef add_leaf(const BuiltNode& leaf) {
    const auto first = static_cast<std::uint32_t>(tree_.order.size());
    tree_.order.insert(tree_.order.end(), leaf.record, leaf.record + leaf.records);
    return NodeRef::leaf(first, leaf.records);
  }

  static void set_box(WideNode& node, unsigned i, const RTCBounds& b) {
    node.lo[0][i] = b.lower_x, node.lo[1][i] = b.lower_y, node.lo[2][i] = b.lower_z;
    node.hi[0][i] = b.upper_x, node.hi[1][i] = b.upper_y, node.hi[2][i] = b.upper_z;
    node.used |= 1u << i;
  }

 private:
  BoxTree& tree_;
};

/// What Embree has last complained of, as an exception. Null: of calls without a device.
[[noreturn]] void fail(RTCDevice device) {
  const RTCError error = rtcGetDeviceError(device);
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  throw std::runtime_error("Embree could not build the hierarchy: error " + std::to_string(error));
}

}  // namespace

BoxTree build_box_tree(std::span<const Box> boxes, std::uint32_t tested_together) {
  BoxTree tree;
  if (boxes.empty()) return tree;
  if (boxes.size() >= 1u << 27) throw std::length_error("more than 2^27 primitives");
  const std::unique_ptr<RTCDeviceTy, decltype(&rtcReleaseDevice)> device(rtcNewDevice(nullptr),
                                                                         &rtcReleaseDevice);
  if (!device) fail(nullptr);
  const std::unique_ptr<RTCBVHTy, decltype(&rtcReleaseBVH)> bvh(rtcNewBVH(device.get()),
                                                                &rtcReleaseBVH);
  if (!bvh) fail(device.get());
  std::vector<RTCBuildPrimitive> primitives(boxes.size());
  for (unsigned i = 0; i < boxes.size(); ++i) primitives[i] = build_primitive(boxes[i], i);

  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  arguments.buildQuality = RTC_BUILD_QUALITY_HIGH;
  arguments.maxBranchingFactor = WideNode::width;
  arguments.maxDepth = most_levels;
  arguments.sahBlockSize = tested_together;
  arguments.minLeafSize = 1;
  arguments.maxLeafSize = 8;
  arguments.traversalCost = 1;
  arguments.intersectionCost = 1;
  arguments.bvh = bvh.get();
  arguments.primitives = primitives.data();
  arguments.primitiveCount = primitives.size();
  arguments.primitiveArrayCapacity = primitives.size();
  arguments.createNode = create_node;
  arguments.setNodeChildren = set_children;
  arguments.setNodeBounds = set_boxes;
  arguments.createLeaf = create_leaf;
  const auto* root = static_cast<const BuiltNode*>(rtcBuildBVH(&arguments));
  if (!root) fail(device.get());

  tree.order.reserve(boxes.size());
  Flattener flattener(tree);
  if (root->children > 0) {
    flattener.add(*root);
  } else {  // all boxes in one leaf: a root with one child
    tree.nodes.emplace_back();
    WideNode node;
    node.child[0] = flattener.add_leaf(*root);
    Box box;
    for (const Box& b : boxes) box.add(b);
    Flattener::set_box(node, 0, {box.lo.x, box.lo.y, box.lo.z, 0, box.hi.x, box.hi.y, box.hi.z, 0});
    tree.nodes[0] = node;
  }
  tree.nodes.shrink_to_fit();
  return tree;
}

namespace {

bool is_mesh(const std::vector<Record>& records) {
  const auto triangles = std::count_if(records.begin(), records.end(), [](const Record& record) {
    return record.kind == ShapeKind::triangle;
  });
  return 2 * static_cast<std::size_t>(triangles) > records.size();
}

/// Turns leaves that hold placements into nodes with a child for each of these, and one for the
/// records. Boxes and placements follow the records in the order of `boxes`.
class PlacementHanger {
 public:
  PlacementHanger(BoxTree& tree, std::span<const Box> boxes, std::size_t records)
      : tree_(tree), boxes_(boxes), records_(records) {}

  void hang() {
    std::vector<std::uint32_t> order;
    for (std::size_t n = 0, count = tree_.nodes.size(); n < count; ++n)
      for (int child = 0; child < WideNode::width; ++child)
        if (tree_.nodes[n].used >> child & 1 && tree_.nodes[n].child[child].is_leaf()) {
          const NodeRef moved = without_placements(tree_.nodes[n].child[child], order);
          tree_.nodes[n].child[child] = moved;
        }
    tree_.order = std::move(order);
  }

 private:
  NodeRef without_placements(NodeRef leaf, std::vector<std::uint32_t>& order) {
    const std::span all = std::span(tree_.order).subspan(leaf.first(), leaf.count());
    // The leaf's order is by index: records first.
    const auto records =
        static_cast<std::size_t>(std::lower_bound(all.begin(), all.end(), records_) - all.begin());
    const auto first = static_cast<std::uint32_t>(order.size());
    order.insert(order.end(), all.begin(), all.begin() + static_cast<std::ptrdiff_t>(records));
    const auto run = [&] { return NodeRef::leaf(first, static_cast<std::uint32_t>(records)); };
    if (records == all.size()) return run();
    const auto placement = [&](std::uint32_t i) {
      return NodeRef::placement(i - static_cast<std::uint32_t>(records_));
    };
    if (all.size() == 1) return placement(all[0]);
    WideNode node;
    unsigned child = 0;
    const auto add = [&](NodeRef ref, const Box& b) {
      node.child[child] = ref;
      Flattener::set_box(node, child++, {b.lo.x, b.lo.y, b.lo.z, 0, b.hi.x, b.hi.y, b.hi.z, 0});
    };
    if (records > 0) {
      Box box;
      for (const std::uint32_t i : all.first(records)) box.add(boxes_[i]);
      add(run(), box);
    }
    for (const std::uint32_t i : all.subspan(records)) add(placement(i), boxes_[i]);
    tree_.nodes.push_back(node);
    return NodeRef::inner(static_cast<std::uint32_t>(tree_.nodes.size() - 1));
  }

  BoxTree& tree_;
  std::span<const Box> boxes_;
  std::size_t records_;
};

}  // namespace

Box bounds(const WideNode& node) {
  Box box;
  for (int i = 0; i < WideNode::width; ++i)
    if (node.used >> i & 1) box.add(box_of(node, i));
  return box;
}

void refit_boxes(WideTree& tree) {
  const auto box_below = [&](NodeRef child) {
    if (child.is_placement()) return tree.placements[child.placed()].box;
    if (!child.is_leaf()) return bounds(tree.nodes[child.node()]);
    Box box;
    for (std::uint32_t i = 0; i < child.count(); ++i)
      box.add(bounds(tree.records[child.first() + i]));
    return box;
  };
  // Children stand behind their parents.
  for (std::size_t n = tree.nodes.size(); n-- > 0;)
    for (unsigned child = 0; child < WideNode::width; ++child) {
      if (!(tree.nodes[n].used >> child & 1)) continue;
      const Box b = box_below(tree.nodes[n].child[child]);
      Flattener::set_box(tree.nodes[n], child,
                         {b.lo.x, b.lo.y, b.lo.z, 0, b.hi.x, b.hi.y, b.hi.z, 0});
    }
}

std::size_t WideTree::memory_bytes() const {
  std::size_t sum = nodes.capacity() * sizeof(WideNode) + records.capacity() * sizeof(Record) +
                    placements.capacity() * sizeof(Placement);
  for (const WideTree& group : groups) sum += sizeof group + group.memory_bytes();
  return sum;
}

WideTree build_wide_tree(const std::vector<Record>& records, std::vector<WideTree> groups,
                         std::vector<Placement> placements) {
  std::vector<Box> boxes;
  boxes.reserve(records.size() + placements.size());
  for (const Record& record : records) boxes.push_back(bounds(record));
  for (const Placement& placement : placements) boxes.push_back(placement.box);
  BoxTree boxed = build_box_tree(boxes, is_mesh(records) ? 4 : 1);
  if (!placements.empty()) PlacementHanger(boxed, boxes, records.size()).hang();
  WideTree tree{std::move(boxed.nodes), {}, std::move(groups), std::move(placements)};
  tree.records.reserve(records.size());
  for (const std::uint32_t i : boxed.order) tree.records.push_back(records[i]);
  return tree;
}

}  // namespace penumbra
