// SPDX-License-Identifier: MIT
// Rays and shafts down any hierarchy, for those who bring tests of their own.
#include "penumbra/kernel/kernel.h"
#include "penumbra/kernel/traverse.h"

// Highway compiles the rest once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "penumbra/kernel/walk.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "penumbra/kernel/walk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

bool Walk(std::span<const WideNode> nodes, const Ray& ray, VisitLeaf leaf, void* context) {
  if (nodes.empty()) return false;
  const Shaft shaft = make_shaft(ray.origin, ray.direction, ray.t_max);
  return walk_from(nodes, NodeRef::inner(0), shaft, [&](std::uint32_t first, std::uint32_t count) {
    return leaf(context, first, count);
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
  if (nodes.empty()) return false;
  Shaft shaft = make_shaft(bounds.receivers, bounds.least, bounds.most, 1);
  shaft.pad = 4 * box_pad;
  NodeRef stack[stack_size];
  int top = 0;
  stack[top++] = NodeRef::inner(0);
  while (top > 0) {
    const NodeRef ref = stack[--top];
    if (ref.is_leaf()) {
      if (leaf(context, ref.first(), ref.count())) return true;
      continue;
    }
    const WideNode& node = nodes[ref.node()];
    alignas(32) float near[WideNode::width];
    std::uint32_t met = overlap(shaft, node, near).met & above_floor(bounds, node);
    for (; met != 0; met &= met - 1) {
      const NodeRef child = node.child[__builtin_ctz(met)];
      prefetch(nodes, records, child);
      stack[top++] = child;
    }
  }
  return false;
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
