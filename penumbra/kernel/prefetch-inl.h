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
#include <span>

#include "penumbra/kernel/wide_tree.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

/// The records of a leaf, or a node.
HWY_INLINE void prefetch(std::span<const WideNode> nodes, std::span<const Record> records,
                         NodeRef ref) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(
      ref.is_leaf() ? static_cast<const void*>(&records[ref.first()])
                    : static_cast<const void*>(&nodes[ref.node()]));
  const std::size_t size = ref.is_leaf() ? ref.count() * sizeof(Record) : sizeof(WideNode);
  for (std::size_t i = 0; i < size; i += 64) hwy::Prefetch(bytes + i);
}

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // include once for each instruction set
