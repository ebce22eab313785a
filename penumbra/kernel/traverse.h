// SPDX-License-Identifier: MIT
// The questions a kernel answers, over records: by hierarchy, and by brute force.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include "penumbra/geometry/light_sampling.h"
#include "penumbra/kernel/wide_tree.h"

namespace penumbra {

struct Ray;

/// The nearest record that a ray meets; null if none.
struct NearestRecord {
  float t = 0;
  const Record* record = nullptr;
  std::uint32_t tests = 0;
};

inline constexpr std::uint32_t no_record = 0xffffffffu;

/// What an any-hit query did: (ray, record) tests, and the last record that was found to block
/// (`no_record` if none).
struct OccludedReport {
  std::uint64_t tests = 0;
  std::uint32_t blocker = no_record;
};

/// The two records that blocked last (paper, sections 2 and 5).
struct RecentRecords {
  std::array<std::uint32_t, 2> record{no_record, no_record};

  /// A hit: `blocker` comes to the front, once.
  void move_to_front(std::uint32_t blocker) {
    if (record[0] != blocker) record[1] = record[0];
    record[0] = blocker;
  }
  /// A miss drops the last.
  void drop_last() { (record[1] != no_record ? record[1] : record[0]) = no_record; }
};

/// What any-hit queries of single rays did: (ray, record) tests; rays that a recent record blocked;
/// rays that went through the tree.
struct SingleReport {
  std::uint64_t tests = 0, decided = 0, traced = 0;
};

// Through the tree, on the best instruction set that this processor has.
NearestRecord nearest(const WideTree& tree, const Ray& ray);
OccludedReport occluded(const WideTree& tree, const LightSamples& rays,
                        std::span<const std::uint32_t> active, std::span<std::uint32_t> blocked);

/// The same, one ray after the other, as tracers did before packets: a recent record that blocks
/// the ray decides it; a traced ray moves what blocked it to the front, or drops the last.
SingleReport occluded_singly(const WideTree& tree, const LightSamples& rays,
                             std::span<const std::uint32_t> active, RecentRecords& recent,
                             std::span<std::uint32_t> blocked);

/// Any hit against the records of a list alone, in its order.
OccludedReport occluded_among(std::span<const Record> records, std::span<const std::uint32_t> list,
                              const LightSamples& rays, std::span<const std::uint32_t> active,
                              std::span<std::uint32_t> blocked);

/// The leaves that a ray may pass, nearest child first: `leaf(context, first, count)` gets runs of
/// the tree's order, and ends the walk when it returns true. Passes by no box that the ray meets,
/// grown by 2^-19 of its farthest coordinate from the origin (see intersect-inl.h). Returns whether
/// a leaf ended it.
using VisitLeaf = bool (*)(void* context, std::uint32_t first, std::uint32_t count);
bool walk(std::span<const WideNode> nodes, const Ray& ray, VisitLeaf leaf, void* context);

/// A callable bool(first, count) as VisitLeaf; the context is its address.
template <class Leaf>
bool call_leaf(void* context, std::uint32_t first, std::uint32_t count) {
  return (*static_cast<Leaf*>(context))(first, count);
}

template <class Leaf>
bool walk(std::span<const WideNode> nodes, const Ray& ray, Leaf leaf) {
  return walk(nodes, ray, call_leaf<Leaf>, &leaf);
}

/// The hull of a box of receiver points and a convex set of targets, as boxes see it: at t in [0,
/// 1] it reaches along each axis from receivers.lo + t least to receivers.hi + t most. For targets
/// in a box, least and most are its corners minus those of the receivers; where the targets move
/// with p (a sun), the box of what is added to it.
/// Of it only what lies in a half-space counts: where `up` . x >= `floor`.
struct ShaftBounds {
  Box receivers;
  Vec3f least, most;
  Vec3f up{};
  float floor = -std::numeric_limits<float>::infinity();
};

/// The leaves that a shaft may pass, in no order: every record that blocks a ray of the shaft is in
/// one of them. `records`, those of the leaves.
bool walk(std::span<const WideNode> nodes, std::span<const Record> records,
          const ShaftBounds& shaft, VisitLeaf leaf, void* context);

template <class Leaf>
bool walk(std::span<const WideNode> nodes, std::span<const Record> records,
          const ShaftBounds& shaft, Leaf leaf) {
  return walk(nodes, records, shaft, call_leaf<Leaf>, &leaf);
}

// One ray and one record at a time, on the compiler's baseline instruction set: the judge.
NearestRecord nearest_brute(std::span<const Record> records, const Ray& ray);
OccludedReport occluded_brute(std::span<const Record> records, const LightSamples& rays,
                              std::span<const std::uint32_t> active,
                              std::span<std::uint32_t> blocked);

/// The instruction set that `nearest` and `occluded` run on, such as "AVX2".
const char* instruction_set();

}  // namespace penumbra
