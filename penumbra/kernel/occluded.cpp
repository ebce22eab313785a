// SPDX-License-Identifier: MIT
// Any hit for the rays of one receiver. They go down the hierarchy together as one shaft; where the
// shaft is wider than half a child's box, each ray is tested against the box. Where at most half of
// the rays are left, each is tested against all boxes of a node, still in one traversal, so that
// every node and leaf is fetched once. What is found does not depend on any of this.
#include <span>

#include "penumbra/kernel/traverse.h"

// Highway compiles the rest once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "penumbra/kernel/occluded.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "penumbra/kernel/packet-inl.h"
#include "penumbra/kernel/prefetch-inl.h"
#include "penumbra/kernel/space-inl.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

struct Progress {
  std::uint32_t remaining = 0;
  OccludedReport report;
};

/// With so few rays, triangles are tried four at a time and ray by ray; with more, rays in lanes.
constexpr int few = 8;

/// Tests `count` records until every wanted ray is blocked. record(i) points to number i, at least
/// until i + 4 is asked for; index(i) is its index.
template <class At, class Index>
HWY_INLINE void test_records(std::uint32_t count, At&& record_at, Index&& index,
                             const Packet& packet, std::uint32_t wanted, Progress& progress) {
  alignas(16) std::uint32_t passed[4] = {};
  for (std::uint32_t i = 0; i < count && wanted != 0; ++i) {
    const Record& record = *record_at(i);
    const int rays = __builtin_popcount(wanted);
    if (i % 4 == 0) {
      std::fill(passed, passed + 4, 0u);
      if (record.kind == ShapeKind::triangle && rays <= few) {
        const auto at = [&](std::uint32_t k) { return k < count ? record_at(k) : &record; };
        const Record* const four[] = {&record, at(i + 1), at(i + 2), at(i + 3)};
        passed_by(four, packet, wanted, passed);
      }
    }
    if (!record.casts_shadow) continue;
    progress.report.tests += static_cast<std::uint64_t>(rays);
    const std::uint32_t doubtful = wanted & ~passed[i % 4];
    if (doubtful == 0) continue;
    const std::uint32_t blocked = blocked_by(record, packet, doubtful);
    if (blocked == 0) continue;
    wanted &= ~blocked;
    progress.remaining &= ~blocked;
    progress.report.blocker = index(i);
  }
}

/// Some rays of a packet, and the shaft around them.
struct PacketShaft {
  PacketShaft(const Packet& packet_, std::uint32_t wanted_)
      : packet(packet_),
        wanted(wanted_),
        population(__builtin_popcount(wanted_)),
        shaft(make_shaft(packet_.rays, packet_.first, wanted_)) {}
  const Packet& packet;
  std::uint32_t wanted;
  int population;
  Shaft shaft;
};

template <class Tree>
void traverse(const Tree& tree, const PacketShaft& in, Progress& progress) {
  struct Entry {
    NodeRef ref;
    std::uint32_t wanted;
  };
  const Packet& packet = in.packet;
  typename Tree::Room room;
  Entry stack[stack_size];
  int top = 0;
  stack[top++] = {NodeRef::inner(0), in.wanted};
  while (top > 0) {
    const Entry entry = stack[--top];
    const std::uint32_t rays = entry.wanted & progress.remaining;
    if (rays == 0) continue;
    if (entry.ref.is_leaf()) {
      const std::span<const Record> records = tree.records(entry.ref, room);
      const std::uint32_t first = tree.first(entry.ref);
      test_records(
          entry.ref.count(), [&](std::uint32_t i) { return &records[i]; },
          [&](std::uint32_t i) { return first + i; }, packet, rays, progress);
      continue;
    }
    if constexpr (Tree::has_placements)
      if (entry.ref.is_placement()) {
        traverse(PlacedTree(tree.tree, entry.ref), PacketShaft(packet, rays), progress);
        continue;
      }
    const WideNode& node = tree.node(entry.ref, room);
    alignas(32) std::uint32_t through[WideNode::width];
    if (2 * __builtin_popcount(rays) <= in.population) {
      each_ray(through_boxes(node, packet, rays, through), [&](std::uint32_t child) {
        stack[top++] = {node.child[child], through[child]};
        prefetch(tree.tree, node.child[child]);
      });
      continue;
    }
    alignas(32) float near[WideNode::width];
    const Overlap children = overlap(in.shaft, node, near);
    each_ray(children.met, [&](std::uint32_t child) { prefetch(tree.tree, node.child[child]); });
    each_ray(children.met, [&](std::uint32_t child) {
      const bool is_wide = in.population > 1 && (children.wide >> child & 1);
      const std::uint32_t left =
          is_wide ? through_box(node, static_cast<int>(child), packet, rays) : rays;
      if (left != 0) stack[top++] = {node.child[child], left};
    });
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
    traverse(WholeTree{tree}, PacketShaft(packet, active[word]), progress);
    blocked[word] = active[word] & ~progress.remaining;
  }
  return progress.report;
}

/// One ray of a packet.
bool is_occluded(const WideTree& tree, const Packet& packet, std::uint32_t bit,
                 RecentRecords& recent, SingleReport& report) {
  Record room;
  for (const std::uint32_t record : recent.record) {
    if (record == no_record) continue;
    ++report.tests;
    if (blocked_by(RecordTable(tree).get(record, room), packet, bit) == 0) continue;
    ++report.decided;
    return true;
  }
  Progress progress{bit, {}};
  traverse(WholeTree{tree}, PacketShaft(packet, bit), progress);
  ++report.traced;
  report.tests += progress.report.tests;
  if (progress.remaining == 0)
    recent.move_to_front(progress.report.blocker);
  else
    recent.drop_last();
  return progress.remaining == 0;
}

SingleReport OccludedSingly(const WideTree& tree, const LightSamples& rays,
                            std::span<const std::uint32_t> active, RecentRecords& recent,
                            std::span<std::uint32_t> blocked) {
  SingleReport report;
  for (std::uint32_t word = 0; 32 * word < rays.count; ++word) {
    blocked[word] = 0;
    if (active[word] == 0 || tree.nodes.empty()) continue;
    const Packet packet(rays, 32 * word);  // what a ray needs of its own direction, for all of them
    each_ray(active[word], [&](std::uint32_t ray) {
      if (is_occluded(tree, packet, 1u << ray, recent, report)) blocked[word] |= 1u << ray;
    });
  }
  return report;
}

OccludedReport OccludedAmong(const RecordTable& records, std::span<const std::uint32_t> list,
                             const LightSamples& rays, std::span<const std::uint32_t> active,
                             std::span<std::uint32_t> blocked) {
  Progress progress;
  Record room[4];
  const auto record_at = [&](std::uint32_t i) { return &records.get(list[i], room[i % 4]); };
  const auto index = [&](std::uint32_t i) { return list[i]; };
  for (std::uint32_t word = 0; 32 * word < rays.count; ++word) {
    blocked[word] = 0;
    if (active[word] == 0) continue;
    progress.remaining = active[word];
    test_records(static_cast<std::uint32_t>(list.size()), record_at, index, Packet(rays, 32 * word),
                 active[word], progress);
    blocked[word] = active[word] & ~progress.remaining;
  }
  return progress.report;
}

}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace penumbra {

HWY_EXPORT(OccludedWide);
HWY_EXPORT(OccludedSingly);
HWY_EXPORT(OccludedAmong);

OccludedReport occluded(const WideTree& tree, const LightSamples& rays,
                        std::span<const std::uint32_t> active, std::span<std::uint32_t> blocked) {
  return HWY_DYNAMIC_DISPATCH(OccludedWide)(tree, rays, active, blocked);
}

SingleReport occluded_singly(const WideTree& tree, const LightSamples& rays,
                             std::span<const std::uint32_t> active, RecentRecords& recent,
                             std::span<std::uint32_t> blocked) {
  return HWY_DYNAMIC_DISPATCH(OccludedSingly)(tree, rays, active, recent, blocked);
}

OccludedReport occluded_among(const RecordTable& records, std::span<const std::uint32_t> list,
                              const LightSamples& rays, std::span<const std::uint32_t> active,
                              std::span<std::uint32_t> blocked) {
  return HWY_DYNAMIC_DISPATCH(OccludedAmong)(records, list, rays, active, blocked);
}

}  // namespace penumbra
#endif
