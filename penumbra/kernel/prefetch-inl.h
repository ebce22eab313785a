// SPDX-License-Identifier: MIT
// What a traversal will need soon: most of its time on a large mesh is waiting for memory.
//
// Highway "inl" header: included once for each instruction set.

#if defined(PENUMBRA_KERNEL_PREFETCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PENUMBRA_KERNEL_PREFETCH_INL_H_
#undef PENUMBRA_KERNEL_PREFETCH_INL_H_
#else
#define PENUMBRA_KERNEL_PREFETCH_INL_H_
#endif

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "penumbra/kernel/wide_tree.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

/// The records of a leaf, or a node.
HWY_INLINE void prefetch(const WideTree& tree, NodeRef ref) {
  if (ref.is_placement()) return;
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(
      ref.is_leaf() ? static_cast<const void*>(&tree.records[ref.first()])
                    : static_cast<const void*>(&tree.nodes[ref.node()]));
  const std::size_t size = ref.is_leaf() ? ref.count() * sizeof(Record) : sizeof(WideNode);
  for (std::size_t i = 0; i < size; i += 64) hwy::Prefetch(bytes + i);
}

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include once for each instruction set
