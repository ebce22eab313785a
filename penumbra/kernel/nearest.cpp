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

#include "penumbra/kernel/four_triangles-inl.h"
#include "penumbra/kernel/search-inl.h"
#include "penumbra/kernel/shaft-inl.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

using One = hn::CappedTag<float, 1>;

/// The records of a leaf; those that the ray passes by cannot be hit.
HWY_INLINE void search_leaf(const Record* records, std::uint32_t count, Vec3f origin,
                            const RayLanes<One>& ray, Search& search) {
  const Shear shear{hn::GetLane(ray.shear_x), hn::GetLane(ray.shear_y),
                    static_cast<int>(hn::GetLane(ray.axis))};
  std::uint8_t passed[8] = {};
  for (std::uint32_t i = 0; i < count; ++i) {
    if (i % 4 == 0) {
      passed[0] = 0;
      if (records[i].kind == ShapeKind::triangle) {
        const auto at = [&](std::uint32_t k) { return records + std::min(k, count - 1); };
        const Record* const four[] = {at(i), at(i + 1), at(i + 2), at(i + 3)};
        hn::StoreMaskBits(FourTriangles::D(), FourTriangles(four, origin).passed_by(shear), passed);
      }
    }
    if (!(passed[0] >> i % 4 & 1)) search_record(One(), records[i], origin, ray, search);
  }
}

NearestRecord NearestWide(const WideTree& tree, const Ray& ray) {
  const One d;
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
    if (search.nearest.record && entry.near > search.nearest.t) continue;
    if (entry.ref.is_leaf()) {
      search_leaf(&tree.records[entry.ref.first()], entry.ref.count(), ray.origin, lanes, search);
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
