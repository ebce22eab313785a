// SPDX-License-Identifier: MIT
// Any hit for the rays of one receiver. They go down the hierarchy together as one shaft; where the
// shaft is wider than half a child's box, each ray is tested against the box. Where at most half of
// the rays are left, each is tested against all boxes of a node, still in one traversal, so that
// every node and leaf is fetched once. What is found does not depend on any of this.
#include "penumbra/kernel/traverse.h"

// Highway compiles the rest once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "penumbra/kernel/occluded.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "penumbra/kernel/packet-inl.h"
#include "penumbra/kernel/prefetch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {

struct Progress {
  std::uint32_t remaining = 0;
  OccludedReport report;
};

/// With so few rays, triangles are tried four at a time and ray by ray; with more, rays in lanes.
constexpr int few = 8;

/// Tests `count` records, number i being records[index(i)], until every wanted ray is blocked.
template <class Index>
HWY_INLINE void test_records(std::span<const Record> records, std::uint32_t count, Index&& index,
                             const Packet& packet, std::uint32_t wanted, Progress& progress) {
  alignas(16) std::uint32_t passed[4] = {};
  for (std::uint32_t i = 0; i < count && wanted != 0; ++i) {
    const Record& record = records[index(i)];
    const int rays = __builtin_popcount(wanted);
    if (i % 4 == 0) {
      std::fill(passed, passed + 4, 0u);
      if (record.kind == ShapeKind::triangle && rays <= few) {
        const auto at = [&](std::uint32_t k) { return &records[index(std::min(k, count - 1))]; };
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

void traverse(const WideTree& tree, const Packet& packet, std::uint32_t wanted,
              Progress& progress) {
  struct Entry {
    NodeRef ref;
    std::uint32_t wanted;
  };
  const Shaft shaft = make_shaft(packet.rays, packet.first, wanted);
  const int population = __builtin_popcount(wanted);
  Entry stack[stack_size];
  int top = 0;
  stack[top++] = {NodeRef::inner(0), wanted};
  while (top > 0) {
    const Entry entry = stack[--top];
    const std::uint32_t rays = entry.wanted & progress.remaining;
    if (rays == 0) continue;
    if (entry.ref.is_leaf()) {
      const auto index = [&](std::uint32_t i) { return entry.ref.first() + i; };
      test_records(tree.records, entry.ref.count(), index, packet, rays, progress);
      continue;
    }
    const WideNode& node = tree.nodes[entry.ref.node()];
    alignas(32) std::uint32_t through[WideNode::width];
    if (2 * __builtin_popcount(rays) <= population) {
      each_ray(through_boxes(node, packet, rays, through), [&](std::uint32_t child) {
        stack[top++] = {node.child[child], through[child]};
        prefetch(tree.nodes, tree.records, node.child[child]);
      });
      continue;
    }
    alignas(32) float near[WideNode::width];
    const Overlap children = overlap(shaft, node, near);
    each_ray(children.met,
             [&](std::uint32_t child) { prefetch(tree.nodes, tree.records, node.child[child]); });
    each_ray(children.met, [&](std::uint32_t child) {
      const bool is_wide = population > 1 && (children.wide >> child & 1);
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
    traverse(tree, packet, active[word], progress);
    blocked[word] = active[word] & ~progress.remaining;
  }
  return progress.report;
}

/// One ray of a packet.
bool is_occluded(const WideTree& tree, const Packet& packet, std::uint32_t bit,
                 RecentRecords& recent, SingleReport& report) {
  for (const std::uint32_t record : recent.record) {
    if (record == no_record) continue;
    ++report.tests;
    if (blocked_by(tree.records[record], packet, bit) == 0) continue;
    ++report.decided;
    return true;
  }
  Progress progress{bit, {}};
  traverse(tree, packet, bit, progress);
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

OccludedReport OccludedAmong(std::span<const Record> records, std::span<const std::uint32_t> list,
                             const LightSamples& rays, std::span<const std::uint32_t> active,
                             std::span<std::uint32_t> blocked) {
  Progress progress;
  const auto index = [&](std::uint32_t i) { return list[i]; };
  for (std::uint32_t word = 0; 32 * word < rays.count; ++word) {
    blocked[word] = 0;
    if (active[word] == 0) continue;
    progress.remaining = active[word];
    test_records(records, static_cast<std::uint32_t>(list.size()), index, Packet(rays, 32 * word),
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

OccludedReport occluded_among(std::span<const Record> records, std::span<const std::uint32_t> list,
                              const LightSamples& rays, std::span<const std::uint32_t> active,
                              std::span<std::uint32_t> blocked) {
  return HWY_DYNAMIC_DISPATCH(OccludedAmong)(records, list, rays, active, blocked);
}

}  // namespace penumbra
#endif
