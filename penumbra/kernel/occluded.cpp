// SPDX-License-Identifier: MIT
// Any hit for the rays of one receiver. They go down the hierarchy together as one shaft; where the
// shaft is wider than half a child's box, each ray is tested against the box, and when at most half
// of the rays are left, they go on as a shaft of their own, down to single rays. What is found does
// not depend on any of this.
#include "penumbra/kernel/traverse.h"

// Highway compiles the rest once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "penumbra/kernel/occluded.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "penumbra/kernel/intersect-inl.h"
#include "penumbra/kernel/shaft-inl.h"
#include "penumbra/kernel/walk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

using Lanes = hn::CappedTag<float, 16>;
using LanesV = hn::Vec<Lanes>;
using LanesM = hn::Mask<Lanes>;
constexpr Lanes lanes_tag;
constexpr std::uint32_t lane_count = hn::MaxLanes(Lanes());

/// Up to 32 rays of a receiver: what is derived from their directions, in groups of lanes.
struct Packet {
  static constexpr std::uint32_t most = 32;

  HWY_INLINE Packet(const LightSamples& rays_, std::uint32_t first_)
      : rays(rays_),
        first(first_),
        groups((std::min(rays_.count - first_, most) + lane_count - 1) / lane_count) {
    for (std::uint32_t g = 0; g < groups; ++g) {
      const std::uint32_t i = first + g * lane_count;
      const LanesV x = hn::LoadU(lanes_tag, &rays.x[i]), y = hn::LoadU(lanes_tag, &rays.y[i]),
                   z = hn::LoadU(lanes_tag, &rays.z[i]);
      ray[g] = make_ray_lanes(lanes_tag, x, y, z);
      inverse[g][0] = safe_reciprocal(lanes_tag, x);
      inverse[g][1] = safe_reciprocal(lanes_tag, y);
      inverse[g][2] = safe_reciprocal(lanes_tag, z);
    }
  }

  const LightSamples& rays;
  std::uint32_t first, groups;
  RayLanes<Lanes> ray[most / lane_count];
  LanesV inverse[most / lane_count][3];
};

HWY_INLINE LanesM mask_of(std::uint32_t bits) {
  const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits),
                                 static_cast<std::uint8_t>(bits >> 8)};
  return hn::LoadMaskBits(lanes_tag, bytes);
}

HWY_INLINE std::uint32_t bits_of(LanesM mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(lanes_tag, mask, bytes);
  return bytes[0] | std::uint32_t(bytes[1]) << 8;
}

/// Calls f(group, bits) for each group of lanes with wanted rays; gathers the bits it returns.
template <class F>
HWY_INLINE std::uint32_t each_group(const Packet& packet, std::uint32_t wanted, F&& f) {
  constexpr std::uint32_t all = (1u << lane_count) - 1;
  std::uint32_t met = 0;
  for (std::uint32_t g = 0; g < packet.groups; ++g)
    if (const std::uint32_t bits = wanted >> (g * lane_count) & all)
      met |= (f(g, bits) & bits) << (g * lane_count);
  return met;
}

/// The wanted rays that are blocked by the record.
HWY_INLINE std::uint32_t blocked_by(const Record& record, const Packet& packet,
                                    std::uint32_t wanted) {
  return each_group(packet, wanted, [&](std::uint32_t g, std::uint32_t bits) {
    return bits_of(meets(lanes_tag, record, packet.rays.origin, packet.ray[g],
                         hn::Set(lanes_tag, packet.rays.t_max), mask_of(bits)));
  });
}

/// The wanted rays that meet the box of one child: the shaft's test, ray by ray, and conservative
/// for the same reason.
HWY_INLINE std::uint32_t through_box(const WideNode& node, int child, const Packet& packet,
                                     std::uint32_t wanted) {
  float lo[3], hi[3], reach = 0;
  for (int axis = 0; axis < 3; ++axis) {
    lo[axis] = node.lo[axis][child] - packet.rays.origin[axis];
    hi[axis] = node.hi[axis][child] - packet.rays.origin[axis];
    reach = std::max({reach, std::abs(lo[axis]), std::abs(hi[axis])});
  }
  const float pad = box_pad * reach;
  return each_group(packet, wanted, [&](std::uint32_t g, std::uint32_t) {
    LanesV near = hn::Zero(lanes_tag), far = hn::Set(lanes_tag, packet.rays.t_max);
    for (int axis = 0; axis < 3; ++axis) {
      const LanesV a = hn::Mul(hn::Set(lanes_tag, lo[axis] - pad), packet.inverse[g][axis]);
      const LanesV b = hn::Mul(hn::Set(lanes_tag, hi[axis] + pad), packet.inverse[g][axis]);
      near = hn::Max(near, hn::Min(a, b)), far = hn::Min(far, hn::Max(a, b));
    }
    return bits_of(hn::Le(near, far));
  });
}

struct Progress {
  std::uint32_t remaining = 0;
  OccludedReport report;
};

HWY_INLINE void test_leaf(const WideTree& tree, const Packet& packet, NodeRef leaf,
                          std::uint32_t wanted, Progress& progress) {
  for (std::uint32_t i = 0; i < leaf.count() && wanted != 0; ++i) {
    const Record& record = tree.records[leaf.first() + i];
    if (!record.casts_shadow) continue;
    progress.report.tests += static_cast<std::uint64_t>(__builtin_popcount(wanted));
    const std::uint32_t blocked = blocked_by(record, packet, wanted);
    if (blocked == 0) continue;
    wanted &= ~blocked;
    progress.remaining &= ~blocked;
    progress.report.blocker = leaf.first() + i;
  }
}

/// With so few rays left, each goes alone.
constexpr int few = 4;

void traverse_alone(const WideTree& tree, const LightSamples& rays, std::uint32_t index,
                    NodeRef start, std::uint32_t bit, Progress& progress) {
  const hn::CappedTag<float, 1> d;
  const Vec3f direction{rays.x[index], rays.y[index], rays.z[index]};
  const auto ray =
      make_ray_lanes(d, hn::Set(d, direction.x), hn::Set(d, direction.y), hn::Set(d, direction.z));
  const Shaft shaft = make_shaft(rays.origin, direction, rays.t_max);
  const auto t_max = hn::Set(d, rays.t_max);
  walk_from(tree.nodes, start, shaft, [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t i = first; i < first + count; ++i) {
      const Record& record = tree.records[i];
      if (!record.casts_shadow) continue;
      ++progress.report.tests;
      if (hn::AllFalse(d, meets(d, record, rays.origin, ray, t_max, hn::FirstN(d, 1)))) continue;
      progress.remaining &= ~bit;
      progress.report.blocker = i;
      return true;
    }
    return false;
  });
}

void traverse(const WideTree& tree, const Packet& packet, NodeRef start, std::uint32_t wanted,
              Progress& progress) {
  struct Entry {
    NodeRef ref;
    std::uint32_t wanted;
  };
  const Shaft shaft = make_shaft(packet.rays, packet.first, wanted);
  const int population = __builtin_popcount(wanted);
  Entry stack[stack_size];
  int top = 0;
  stack[top++] = {start, wanted};
  while (top > 0) {
    const Entry entry = stack[--top];
    const std::uint32_t rays = entry.wanted & progress.remaining;
    if (rays == 0) continue;
    if (entry.ref.is_leaf()) {
      test_leaf(tree, packet, entry.ref, rays, progress);
      continue;
    }
    const int left = __builtin_popcount(rays);
    if (2 * left <= population) {
      if (left > few) {
        traverse(tree, packet, entry.ref, rays, progress);
      } else {
        for (std::uint32_t rest = rays; rest != 0; rest &= rest - 1)
          traverse_alone(tree, packet.rays,
                         packet.first + static_cast<std::uint32_t>(__builtin_ctz(rest)), entry.ref,
                         rest & -rest, progress);
      }
      continue;
    }
    const WideNode& node = tree.nodes[entry.ref.node()];
    alignas(32) float near[WideNode::width];
    const Overlap children = overlap(shaft, node, near);
    for (std::uint32_t met = children.met; met != 0; met &= met - 1) {
      const int child = __builtin_ctz(met);
      std::uint32_t through = rays;
      if (population > 1 && (children.wide >> child & 1))
        through = through_box(node, child, packet, rays);
      if (through != 0) stack[top++] = {node.child[child], through};
    }
  }
}

OccludedReport OccludedWide(const WideTree& tree, const LightSamples& rays,
                            std::span<const std::uint32_t> active,
                            std::span<std::uint32_t> blocked) {
  Progress progress;
  for (std::uint32_t word = 0; 32 * word < rays.count; ++word) {
    blocked[word] = 0;
    if (active[word] == 0 || tree.nodes.empty()) continue;
    const Packet packet(rays, 32 * word);
    progress.remaining = active[word];
    traverse(tree, packet, NodeRef::inner(0), active[word], progress);
    blocked[word] = active[word] & ~progress.remaining;
  }
  return progress.report;
}

OccludedReport OccludedAmong(std::span<const Record> records, std::span<const std::uint32_t> list,
                             const LightSamples& rays, std::span<const std::uint32_t> active,
                             std::span<std::uint32_t> blocked) {
  OccludedReport report;
  for (std::uint32_t word = 0; 32 * word < rays.count; ++word) {
    blocked[word] = 0;
    std::uint32_t wanted = active[word];
    if (wanted == 0) continue;
    const Packet packet(rays, 32 * word);
    for (const std::uint32_t index : list) {
      report.tests += static_cast<std::uint64_t>(__builtin_popcount(wanted));
      const std::uint32_t hit = blocked_by(records[index], packet, wanted);
      if (hit == 0) continue;
      report.blocker = index;
      wanted &= ~hit;
      if (wanted == 0) break;
    }
    blocked[word] = active[word] & ~wanted;
  }
  return report;
}

void OccludedByOne(const Record& record, const LightSamples& rays,
                   std::span<const std::uint32_t> active, std::span<std::uint32_t> blocked) {
  for (std::uint32_t word = 0; 32 * word < rays.count; ++word)
    blocked[word] =
        active[word] == 0 ? 0 : blocked_by(record, Packet(rays, 32 * word), active[word]);
}

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace penumbra {

HWY_EXPORT(OccludedWide);
HWY_EXPORT(OccludedAmong);
HWY_EXPORT(OccludedByOne);

OccludedReport occluded(const WideTree& tree, const LightSamples& rays,
                        std::span<const std::uint32_t> active, std::span<std::uint32_t> blocked) {
  return HWY_DYNAMIC_DISPATCH(OccludedWide)(tree, rays, active, blocked);
}

OccludedReport occluded_among(std::span<const Record> records, std::span<const std::uint32_t> list,
                              const LightSamples& rays, std::span<const std::uint32_t> active,
                              std::span<std::uint32_t> blocked) {
  return HWY_DYNAMIC_DISPATCH(OccludedAmong)(records, list, rays, active, blocked);
}

void occluded_by(const Record& record, const LightSamples& rays,
                 std::span<const std::uint32_t> active, std::span<std::uint32_t> blocked) {
  HWY_DYNAMIC_DISPATCH(OccludedByOne)(record, rays, active, blocked);
}

}  // namespace penumbra
#endif
