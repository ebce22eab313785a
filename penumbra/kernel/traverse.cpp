// SPDX-License-Identifier: MIT
#include "penumbra/kernel/traverse.h"

#include "penumbra/kernel/kernel.h"

// Highway compiles the rest once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "penumbra/kernel/traverse.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "penumbra/kernel/search-inl.h"
#include "penumbra/kernel/shaft-inl.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

constexpr int stack_size = 64 * WideNode::width;  // the builder's depth limit times the width

NearestRecord NearestWide(const WideTree& tree, const Ray& ray) {
  const hn::CappedTag<float, 1> d;
  const auto lanes = make_ray_lanes(d, hn::Set(d, ray.direction.x), hn::Set(d, ray.direction.y),
                                    hn::Set(d, ray.direction.z));
  const Shaft shaft = make_shaft(ray.origin, ray.direction, ray.direction, ray.t_max);
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
    for (std::uint32_t children = overlap(shaft, node, near); children != 0;
         children &= children - 1) {
      const int child = __builtin_ctz(children);
      int at = top++;  // insertion sort: the nearest ends on top
      for (; at > bottom && stack[at - 1].near < near[child]; --at) stack[at] = stack[at - 1];
      stack[at] = {near[child], node.child[child]};
    }
  }
  return search.nearest;
}

/// Up to 32 rays of a receiver, in lanes.
template <class D>
struct Packet {
  static constexpr std::size_t most = 32;
  RayLanes<D> lanes[most / hn::MaxLanes(D())];
  std::size_t groups = 0;
};

template <class D>
HWY_INLINE std::uint32_t blocked_by(D d, const Record& record, const LightSamples& rays,
                                    const Packet<D>& packet, std::uint32_t wanted) {
  constexpr std::size_t width = hn::MaxLanes(D());
  constexpr std::uint32_t all = width == 32 ? ~0u : (1u << width) - 1;
  std::uint32_t met = 0;
  for (std::size_t g = 0; g < packet.groups; ++g) {
    const std::uint32_t bits = wanted >> (g * width) & all;
    if (bits == 0) continue;
    const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits),
                                   static_cast<std::uint8_t>(bits >> 8)};
    const auto hit = meets(d, record, rays.origin, packet.lanes[g], hn::Set(d, rays.t_max),
                           hn::LoadMaskBits(d, bytes));
    std::uint8_t out[8] = {};
    hn::StoreMaskBits(d, hit, out);
    met |= (out[0] | std::uint32_t(out[1]) << 8) << (g * width);
  }
  return met;
}

struct WordResult {
  std::uint32_t blocked = 0;
  std::uint64_t tests = 0;
};

/// Rays `first` to first + 31, those of `active`.
WordResult OccludedWord(const WideTree& tree, const LightSamples& rays, std::uint32_t first,
                        std::uint32_t active) {
  using D = hn::CappedTag<float, 16>;
  const D d;
  Packet<D> packet;
  const std::uint32_t count = std::min<std::uint32_t>(rays.count - first, 32);
  for (std::uint32_t i = 0; i < count; i += hn::Lanes(d), ++packet.groups)
    packet.lanes[packet.groups] =
        make_ray_lanes(d, hn::LoadU(d, &rays.x[first + i]), hn::LoadU(d, &rays.y[first + i]),
                       hn::LoadU(d, &rays.z[first + i]));
  const Shaft shaft = make_shaft(rays, first, active);
  WordResult result;
  std::uint32_t remaining = active;
  NodeRef stack[stack_size];
  int top = 0;
  stack[top++] = NodeRef::inner(0);
  while (top > 0) {
    const NodeRef ref = stack[--top];
    if (!ref.is_leaf()) {
      const WideNode& node = tree.nodes[ref.node()];
      alignas(32) float near[WideNode::width];
      for (std::uint32_t children = overlap(shaft, node, near); children != 0;
           children &= children - 1)
        stack[top++] = node.child[__builtin_ctz(children)];
      continue;
    }
    for (std::uint32_t i = 0; i < ref.count(); ++i) {
      const Record& record = tree.records[ref.first() + i];
      if (!record.casts_shadow) continue;
      result.tests += static_cast<std::uint64_t>(__builtin_popcount(remaining));
      remaining &= ~blocked_by(d, record, rays, packet, remaining);
      if (remaining == 0) {
        result.blocked = active;
        return result;
      }
    }
  }
  result.blocked = active & ~remaining;
  return result;
}

std::uint64_t OccludedWide(const WideTree& tree, const LightSamples& rays,
                           std::span<const std::uint32_t> active,
                           std::span<std::uint32_t> blocked) {
  std::uint64_t tests = 0;
  for (std::uint32_t word = 0; 32 * word < rays.count; ++word) {
    blocked[word] = 0;
    if (active[word] == 0 || tree.nodes.empty()) continue;
    const WordResult result = OccludedWord(tree, rays, 32 * word, active[word]);
    blocked[word] = result.blocked;
    tests += result.tests;
  }
  return tests;
}

const char* Name() { return hwy::TargetName(HWY_TARGET); }

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace penumbra {

HWY_EXPORT(NearestWide);
HWY_EXPORT(OccludedWide);
HWY_EXPORT(Name);

NearestRecord nearest(const WideTree& tree, const Ray& ray) {
  return HWY_DYNAMIC_DISPATCH(NearestWide)(tree, ray);
}

std::uint64_t occluded(const WideTree& tree, const LightSamples& rays,
                       std::span<const std::uint32_t> active, std::span<std::uint32_t> blocked) {
  return HWY_DYNAMIC_DISPATCH(OccludedWide)(tree, rays, active, blocked);
}

const char* instruction_set() { return HWY_DYNAMIC_DISPATCH(Name)(); }

}  // namespace penumbra
#endif
