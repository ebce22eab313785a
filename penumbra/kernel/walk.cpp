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

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

/// Calls the leaves, until one ends the walk. `push(node, top)` puts those children of a node that
/// are to be visited on the stack, the first on top, and returns the new top.
template <class Push>
HWY_INLINE bool walk_by(std::span<const WideNode> nodes, VisitLeaf leaf, void* context,
                        Push&& push) {
  if (nodes.empty()) return false;
  NodeRef stack[stack_size];
  NodeRef* top = stack;
  *top++ = NodeRef::inner(0);
  while (top > stack) {
    const NodeRef ref = *--top;
    if (!ref.is_leaf())
      top = push(nodes[ref.node()], top);
    else if (leaf(context, ref.first(), ref.count()))
      return true;
  }
  return false;
}

/// The nearest child first: what blocks one ray is often near what blocked the last.
bool Walk(std::span<const WideNode> nodes, const Ray& ray, VisitLeaf leaf, void* context) {
  const Shaft shaft = make_shaft(ray.origin, ray.direction, ray.t_max);
  return walk_by(nodes, leaf, context, [&](const WideNode& node, NodeRef* top) {
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
  });
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

bool WalkShaft(std::span<const WideNode> nodes, std::span<const Record> records,
               const ShaftBounds& bounds, VisitLeaf leaf, void* context) {
  Shaft shaft = make_shaft(bounds.receivers, bounds.least, bounds.most, 1);
  shaft.pad = 4 * box_pad;
  return walk_by(nodes, leaf, context, [&](const WideNode& node, NodeRef* top) {
    alignas(32) float near[WideNode::width];
    std::uint32_t met = overlap(shaft, node, near).met & above_floor(bounds, node);
    for (; met != 0; met &= met - 1) {
      *top = node.child[__builtin_ctz(met)];
      prefetch(nodes, records, *top++);
    }
    return top;
  });
}

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace penumbra {

HWY_EXPORT(Walk);

bool walk(std::span<const WideNode> nodes, const Ray& ray, VisitLeaf leaf, void* context) {
  return HWY_DYNAMIC_DISPATCH(Walk)(nodes, ray, leaf, context);
}

HWY_EXPORT(WalkShaft);

bool walk(std::span<const WideNode> nodes, std::span<const Record> records,
          const ShaftBounds& shaft, VisitLeaf leaf, void* context) {
  return HWY_DYNAMIC_DISPATCH(WalkShaft)(nodes, records, shaft, leaf, context);
}

}  // namespace penumbra
#endif
