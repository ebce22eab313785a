// SPDX-License-Identifier: MIT
// One ray down any hierarchy, for those who bring tests of their own.
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

bool WalkShaft(std::span<const WideNode> nodes, const ShaftBounds& bounds, VisitLeaf leaf,
               void* context) {
  if (nodes.empty()) return false;
  const Shaft shaft = make_shaft(bounds.receivers, bounds.least, bounds.most, 1);
  return walk_from(nodes, NodeRef::inner(0), shaft, [&](std::uint32_t first, std::uint32_t count) {
    return leaf(context, first, count);
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

bool walk(std::span<const WideNode> nodes, const ShaftBounds& shaft, VisitLeaf leaf,
          void* context) {
  return HWY_DYNAMIC_DISPATCH(WalkShaft)(nodes, shaft, leaf, context);
}

}  // namespace penumbra
#endif
