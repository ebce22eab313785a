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
#include "penumbra/kernel/space-inl.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

using One = hn::CappedTag<float, 1>;

/// The records of a leaf, `first` being the index of the first; those that the ray passes by cannot
/// be hit.
HWY_INLINE void search_leaf(std::span<const Record> records, std::uint32_t first, Vec3f origin,
                            const RayLanes<One>& ray, Search& search) {
  const Shear shear{hn::GetLane(ray.shear_x), hn::GetLane(ray.shear_y),
                    static_cast<int>(hn::GetLane(ray.axis))};
  const auto count = static_cast<std::uint32_t>(records.size());
  std::uint8_t passed[8] = {};
  for (std::uint32_t i = 0; i < count; ++i) {
    if (i % 4 == 0) {
      passed[0] = 0;
      if (records[i].kind == ShapeKind::triangle) {
        const auto at = [&](std::uint32_t k) { return &records[std::min(k, count - 1)]; };
        const Record* const four[] = {at(i), at(i + 1), at(i + 2), at(i + 3)};
        hn::StoreMaskBits(FourTriangles::D(), FourTriangles(four, origin).passed_by(shear), passed);
      }
    }
    if (!(passed[0] >> i % 4 & 1)) search_record(One(), records[i], first + i, origin, ray, search);
  }
}

/// One ray, in the forms that boxes and records want.
struct NearestRay {
  Vec3f origin;
  RayLanes<One> lanes;
  Shaft shaft;
};

template <class Tree>
void search_tree(const Tree& tree, const NearestRay& ray, Search& search) {
  struct Entry {
    float near;
    NodeRef ref;
  };
  typename Tree::Room room;
  Entry stack[stack_size];
  int top = 0;
  stack[top++] = {0, NodeRef::inner(0)};
  while (top > 0) {
    const Entry entry = stack[--top];
    if (search.nearest.record != no_record && entry.near > search.nearest.t) continue;
    if (entry.ref.is_leaf()) {
      search_leaf(tree.records(entry.ref, room), tree.first(entry.ref), ray.origin, ray.lanes,
                  search);
      search.nearest.tests += entry.ref.count();
      continue;
    }
    if constexpr (Tree::has_placements)
      if (entry.ref.is_placement()) {
        search_tree(PlacedTree(tree.tree, entry.ref), ray, search);
        continue;
      }
    const WideNode& node = tree.node(entry.ref, room);
    alignas(32) float near[WideNode::width];
    const int bottom = top;
    for (std::uint32_t children = overlap(ray.shaft, node, near).met; children != 0;
         children &= children - 1) {
      const int child = __builtin_ctz(children);
      int at = top++;  // insertion sort: the nearest ends on top
      for (; at > bottom && stack[at - 1].near < near[child]; --at) stack[at] = stack[at - 1];
      stack[at] = {near[child], node.child[child]};
    }
  }
}

NearestRecord NearestWide(const WideTree& tree, const Ray& ray) {
  const One d;
  const NearestRay one{ray.origin,
                       make_ray_lanes(d, hn::Set(d, ray.direction.x), hn::Set(d, ray.direction.y),
                                      hn::Set(d, ray.direction.z)),
                       make_shaft(ray.origin, ray.direction, ray.t_max)};
  Search search{{}, ray.t_min, ray.t_max};
  if (!tree.nodes.empty()) search_tree(WholeTree{tree}, one, search);
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
