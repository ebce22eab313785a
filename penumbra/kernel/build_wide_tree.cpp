// SPDX-License-Identifier: MIT
#include <embree3/rtcore.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

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

}  // namespace

BoxTree build_box_tree(std::span<const Box> boxes, std::uint32_t tested_together) {
  BoxTree tree;
  if (boxes.empty()) return tree;
  if (boxes.size() >= 1u << 27) throw std::length_error("more than 2^27 primitives");
  const std::unique_ptr<RTCDeviceTy, decltype(&rtcReleaseDevice)> device(rtcNewDevice(nullptr),
                                                                         &rtcReleaseDevice);
  if (!device) throw std::runtime_error("Embree gives no device");
  const std::unique_ptr<RTCBVHTy, decltype(&rtcReleaseBVH)> bvh(rtcNewBVH(device.get()),
                                                                &rtcReleaseBVH);
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
  if (!root) throw std::runtime_error("Embree could not build the hierarchy");

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

WideTree build_wide_tree(const std::vector<Record>& records) {
  std::vector<Box> boxes;
  boxes.reserve(records.size());
  for (const Record& record : records) boxes.push_back(bounds(record));
  const auto triangles = std::count_if(records.begin(), records.end(), [](const Record& record) {
    return record.kind == ShapeKind::triangle;
  });
  const bool is_mesh = 2 * static_cast<std::size_t>(triangles) > records.size();
  BoxTree boxed = build_box_tree(boxes, is_mesh ? 4 : 1);
  WideTree tree{std::move(boxed.nodes), {}};
  tree.records.reserve(records.size());
  for (const std::uint32_t i : boxed.order) tree.records.push_back(records[i]);
  return tree;
}

}  // namespace penumbra
