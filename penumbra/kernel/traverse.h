// SPDX-License-Identifier: MIT
// The questions a kernel answers, over records: by hierarchy, and by brute force.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include "penumbra/geometry/light_sampling.h"
#include "penumbra/kernel/record_table.h"
#include "penumbra/kernel/wide_tree.h"

namespace penumbra {

struct Ray;

inline constexpr std::uint32_t no_record = 0xffffffffu;

/// The nearest record that a ray meets, as an index (`no_record` if none), and its id.
struct NearestRecord {
  float t = 0;
  std::uint32_t record = no_record, id = 0;
  std::uint32_t tests = 0;
};

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
OccludedReport occluded_among(const RecordTable& records, std::span<const std::uint32_t> list,
                              const LightSamples& rays, std::span<const std::uint32_t> active,
                              std::span<std::uint32_t> blocked);

/// The leaves that a ray may pass, nearest child first: `leaf(context, first, count)` gets runs of
/// the tree's order, and ends the walk when it returns true. Passes by no box that the ray meets,
/// grown by 2^-19 of its farthest coordinate from the origin (see intersect-inl.h). Returns whether
/// a leaf ended it.
using VisitLeaf = bool (*)(void* context, std::uint32_t first, std::uint32_t count);
bool walk(std::span<const WideNode> nodes, const Ray& ray, VisitLeaf leaf, void* context);

template <class Leaf>
bool walk(std::span<const WideNode> nodes, const Ray& ray, Leaf leaf) {
  const auto call = [](void* context, std::uint32_t first, std::uint32_t count) {
    return (*static_cast<Leaf*>(context))(first, count);
  };
  return walk(nodes, ray, call, &leaf);
}

/// Records of a leaf as they are in the world, and the index of the first.
using VisitRecords = bool (*)(void* context, std::span<const Record> records, std::uint32_t first);

/// A callable bool(records, first) as VisitRecords; the context is its address.
template <class Visit>
bool call_records(void* context, std::span<const Record> records, std::uint32_t first) {
  return (*static_cast<Visit*>(context))(records, first);
}

/// The same for the records of a placement whose boxes, grown, the ray may pass: each by `below`
/// downwards and by `above` upwards (none negative).
struct Growth {
  Vec3f below, above;
};
bool walk(const WideTree& tree, const Placement& placement, const Growth& growth, const Ray& ray,
          VisitRecords visit, void* context);

template <class Visit>
bool walk(const WideTree& tree, const Placement& placement, const Growth& growth, const Ray& ray,
          Visit visit) {
  return walk(tree, placement, growth, ray, call_records<Visit>, &visit);
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

/// The leaves that a shaft may pass, those of placements included, in no order: every record that
/// blocks a ray of the shaft is in one of them.
bool walk(const WideTree& tree, const ShaftBounds& shaft, VisitRecords visit, void* context);

template <class Visit>
bool walk(const WideTree& tree, const ShaftBounds& shaft, Visit visit) {
  return walk(tree, shaft, call_records<Visit>, &visit);
}

// One ray and one record at a time, on the compiler's baseline instruction set: the judge.
NearestRecord nearest_brute(const RecordTable& records, const Ray& ray);
OccludedReport occluded_brute(const RecordTable& records, const LightSamples& rays,
                              std::span<const std::uint32_t> active,
                              std::span<std::uint32_t> blocked);

/// The instruction set that `nearest` and `occluded` run on, such as "AVX2".
const char* instruction_set();

}  // namespace penumbra
