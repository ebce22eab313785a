// SPDX-License-Identifier: MIT
// Rays and shafts down any hierarchy, for those who bring tests of their own.
#include <limits>
#include <utility>

#include "penumbra/kernel/kernel.h"
#include "penumbra/kernel/traverse.h"

// Highway compiles the rest once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "penumbra/kernel/walk.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "penumbra/kernel/prefetch-inl.h"
#include "penumbra/kernel/shaft-inl.h"
#include "penumbra/kernel/space-inl.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

/// Goes down from the root until `leaf(ref)` says that it is enough. `push(node, top)` puts those
/// children of a node that are to be visited on the stack, the first on top, and returns the new
/// top; `node(ref)` is the node. Leaves are runs and placements.
template <class Node, class Push, class Leaf>
HWY_INLINE bool descend(Node&& node, Push&& push, Leaf&& leaf) {
  NodeRef stack[stack_size];
  NodeRef* top = stack;
  *top++ = NodeRef::inner(0);
  while (top > stack) {
    const NodeRef ref = *--top;
    if (!ref.is_leaf() && !ref.is_placement())
      top = push(node(ref), top);
    else if (leaf(ref))
      return true;
  }
  return false;
}

/// Pushes the children that a ray meets; the nearest comes first: what blocks one ray is often near
/// what blocked the last.
HWY_INLINE NodeRef* push_met(const Shaft& shaft, const WideNode& node, NodeRef* top) {
  alignas(32) float near[WideNode::width];
  NodeRef* nearest = top;
  float least = std::numeric_limits<float>::infinity();
  for (std::uint32_t met = overlap(shaft, node, near).met; met != 0; met &= met - 1) {
    const int child = __builtin_ctz(met);
    if (near[child] < least) least = near[child], nearest = top;
    *top++ = node.child[child];
  }
  if (top > nearest) std::swap(*nearest, top[-1]);
  return top;
}

bool Walk(std::span<const WideNode> nodes, const Ray& ray, VisitLeaf leaf, void* context) {
  if (nodes.empty()) return false;
  const Shaft shaft = make_shaft(ray.origin, ray.direction, ray.t_max);
  return descend([&](NodeRef ref) -> const WideNode& { return nodes[ref.node()]; },
                 [&](const WideNode& node, NodeRef* top) { return push_met(shaft, node, top); },
                 [&](NodeRef ref) { return leaf(context, ref.first(), ref.count()); });
}

bool WalkPlaced(const WideTree& whole, const Placement& placement, const Growth& growth,
                const Ray& ray, VisitRecords visit, void* context) {
  const PlacedTree tree(whole, placement);
  const Shaft shaft = make_shaft(ray.origin, ray.direction, ray.t_max);
  PlacedTree::Room room;
  const auto grown = [&](NodeRef ref) -> const WideNode& {
    tree.node(ref, room);
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < WideNode::width; ++i) {
        room.node.lo[axis][i] -= growth.below[axis];
        room.node.hi[axis][i] += growth.above[axis];
      }
    return room.node;
  };
  return descend(
      grown, [&](const WideNode& node, NodeRef* top) { return push_met(shaft, node, top); },
      [&](NodeRef ref) { return visit(context, tree.records(ref, room), tree.first(ref)); });
}

/// Children that reach into the half-space.
HWY_INLINE std::uint32_t above_floor(const ShaftBounds& bounds, const WideNode& node) {
  const hn::CappedTag<float, WideNode::width> d;
  std::uint32_t met = 0;
  for (std::size_t first = 0; first < WideNode::width; first += hn::Lanes(d)) {
    auto height = hn::Zero(d);
    for (int axis = 0; axis < 3; ++axis) {
      const float* far = bounds.up[axis] >= 0 ? node.hi[axis] : node.lo[axis];
      height = hn::Add(height, hn::Mul(hn::Load(d, far + first), hn::Set(d, bounds.up[axis])));
    }
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, hn::Lt(height, hn::Set(d, bounds.floor)), bytes);  // NaN reaches into it
    met |= std::uint32_t(static_cast<std::uint8_t>(~bytes[0]) & ((1u << hn::Lanes(d)) - 1))
           << first;
  }
  return met;
}

/// A shaft, and who wants the records that it meets.
struct ShaftWalk {
  Shaft shaft;
  const ShaftBounds& bounds;
  VisitRecords visit;
  void* context;
};

template <class Tree>
bool walk_tree(const Tree& tree, const ShaftWalk& walk) {
  typename Tree::Room room;
  const auto push = [&](const WideNode& node, NodeRef* top) {
    alignas(32) float near[WideNode::width];
    std::uint32_t met = overlap(walk.shaft, node, near).met & above_floor(walk.bounds, node);
    for (; met != 0; met &= met - 1) {
      *top = node.child[__builtin_ctz(met)];
      prefetch(tree.tree, *top++);
    }
    return top;
  };
  return descend([&](NodeRef ref) -> const WideNode& { return tree.node(ref, room); }, push,
                 [&](NodeRef ref) {
                   if constexpr (Tree::has_placements)
                     if (ref.is_placement()) return walk_tree(PlacedTree(tree.tree, ref), walk);
                   return walk.visit(walk.context, tree.records(ref, room), tree.first(ref));
                 });
}

bool WalkShaft(const WideTree& tree, const ShaftBounds& bounds, VisitRecords visit, void* context) {
  if (tree.nodes.empty()) return false;
  Shaft shaft = make_shaft(bounds.receivers, bounds.least, bounds.most, 1);
  shaft.pad = 4 * box_pad;
  return walk_tree(WholeTree{tree}, ShaftWalk{shaft, bounds, visit, context});
}

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace penumbra {

HWY_EXPORT(Walk);

bool walk(std::span<const WideNode> nodes, const Ray& ray, VisitLeaf leaf, void* context) {
  return HWY_DYNAMIC_DISPATCH(Walk)(nodes, ray, leaf, context);
}

HWY_EXPORT(WalkPlaced);

bool walk(const WideTree& tree, const Placement& placement, const Growth& growth, const Ray& ray,
          VisitRecords visit, void* context) {
  return HWY_DYNAMIC_DISPATCH(WalkPlaced)(tree, placement, growth, ray, visit, context);
}

HWY_EXPORT(WalkShaft);

bool walk(const WideTree& tree, const ShaftBounds& shaft, VisitRecords visit, void* context) {
  return HWY_DYNAMIC_DISPATCH(WalkShaft)(tree, shaft, visit, context);
}

}  // namespace penumbra
#endif
