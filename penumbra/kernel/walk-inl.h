// SPDX-License-Identifier: MIT
// One ray down the hierarchy, for any-hit questions.
//
// Highway "inl" header: included once for each instruction set.

#if defined(PENUMBRA_KERNEL_WALK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PENUMBRA_KERNEL_WALK_INL_H_
#undef PENUMBRA_KERNEL_WALK_INL_H_
#else
#define PENUMBRA_KERNEL_WALK_INL_H_
#endif

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include "penumbra/kernel/shaft-inl.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

/// What will be needed soon: most of a ray's time on a large mesh is waiting for memory.
HWY_INLINE void prefetch(std::span<const WideNode> nodes, std::span<const Record> records,
                         NodeRef ref) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(
      ref.is_leaf() ? static_cast<const void*>(&records[ref.first()])
                    : static_cast<const void*>(&nodes[ref.node()]));
  const std::size_t size = ref.is_leaf() ? ref.count() * sizeof(Record) : sizeof(WideNode);
  for (std::size_t i = 0; i < size; i += 64) hwy::Prefetch(bytes + i);
}

/// Calls leaf(first, count) for the leaves below `start` that the ray may pass, the nearest child
/// of a node first (what blocks one ray is often near what blocked the last), until it returns
/// true; returns whether it did.
template <class Leaf>
HWY_INLINE bool walk_from(std::span<const WideNode> nodes, NodeRef start, const Shaft& ray,
                          Leaf&& leaf) {
  NodeRef stack[stack_size];
  int top = 0;
  stack[top++] = start;
  while (top > 0) {
    const NodeRef ref = stack[--top];
    if (ref.is_leaf()) {
      if (leaf(ref.first(), ref.count())) return true;
      continue;
    }
    const WideNode& node = nodes[ref.node()];
    alignas(32) float near[WideNode::width];
    int nearest = top;
    float least = std::numeric_limits<float>::infinity();
    for (std::uint32_t met = overlap(ray, node, near).met; met != 0; met &= met - 1) {
      const int child = __builtin_ctz(met);
      if (near[child] < least) least = near[child], nearest = top;
      stack[top++] = node.child[child];
    }
    if (top > nearest) std::swap(stack[nearest], stack[top - 1]);
  }
  return false;
}

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include once for each instruction set
