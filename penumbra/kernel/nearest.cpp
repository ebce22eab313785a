// SPDX-License-Identifier: MIT
// Closest hit of one ray through the hierarchy, nearest child first.
#include "penumbra/kernel/kernel.h"
#include "penumbra/kernel/traverse.h"

// Highway compiles the rest once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "penumbra/kernel/nearest.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "penumbra/kernel/search-inl.h"
#include "penumbra/kernel/shaft-inl.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

NearestRecord NearestWide(const WideTree& tree, const Ray& ray) {
  const hn::CappedTag<float, 1> d;
  const auto lanes = make_ray_lanes(d, hn::Set(d, ray.direction.x), hn::Set(d, ray.direction.y),
                                    hn::Set(d, ray.direction.z));
  const Shaft shaft = make_shaft(ray.origin, ray.direction, ray.t_max);
  Search search{{}, ray.t_min, ray.t_max};
  struct Entry {
    float near;
    NodeRef ref;
  };
  Entry stack[stack_size];
  int top = 0;
  if (!tree.nodes.empty()) stack[top++] = {0, NodeRef::inner(0)};
  while (top > 0) {
    const Entry entry = stack[--top];
    if (search.nearest.found && entry.near > search.nearest.t) continue;
    if (entry.ref.is_leaf()) {
      for (std::uint32_t i = 0; i < entry.ref.count(); ++i)
        search_record(d, tree.records[entry.ref.first() + i], ray.origin, lanes, search);
      search.nearest.tests += entry.ref.count();
      continue;
    }
    const WideNode& node = tree.nodes[entry.ref.node()];
    alignas(32) float near[WideNode::width];
    const int bottom = top;
    for (std::uint32_t children = overlap(shaft, node, near).met; children != 0;
         children &= children - 1) {
      const int child = __builtin_ctz(children);
      int at = top++;  // insertion sort: the nearest ends on top
      for (; at > bottom && stack[at - 1].near < near[child]; --at) stack[at] = stack[at - 1];
      stack[at] = {near[child], node.child[child]};
    }
  }
  return search.nearest;
}

const char* Name() { return hwy::TargetName(HWY_TARGET); }

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace penumbra {

HWY_EXPORT(NearestWide);
HWY_EXPORT(Name);

NearestRecord nearest(const WideTree& tree, const Ray& ray) {
  return HWY_DYNAMIC_DISPATCH(NearestWide)(tree, ray);
}

const char* instruction_set() { return HWY_DYNAMIC_DISPATCH(Name)(); }

}  // namespace penumbra
#endif
