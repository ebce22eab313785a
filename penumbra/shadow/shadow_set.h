// SPDX-License-Identifier: MIT
// The shadow set (paper, section 3): the scene's occluders grown by what its lights require, in a
// hierarchy of its own, with the lights shrunk to their centres. It holds no shapes: a grown
// occluder is a record of the geometry set and how far its offset reaches; the offset itself is
// formed by the test, for the light that is asked for. What an instance places is one occluder, as
// far as its records are grown alike; they are found through the instance's own tree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "penumbra/kernel/traverse.h"
#include "penumbra/shadow/light_hull.h"

namespace penumbra {

/// full: by the whole light (paper, method c). reduced: by t_max (method d).
enum class Offsets { full, reduced };

struct GrownOccluder {
  std::uint32_t caster = 0;  ///< a record that no instance places; behind these the placements
  float t = 1;               ///< the largest t_max over the lights
};

struct ShadowSet {
  std::vector<WideNode> nodes;
  std::vector<GrownOccluder> occluders;  ///< in leaf order
  std::vector<Growth> growth;  ///< of the boxes in each placement, the most over the lights
  std::size_t memory_bytes() const {
    return nodes.capacity() * sizeof(WideNode) + occluders.capacity() * sizeof(GrownOccluder) +
           growth.capacity() * sizeof(Growth);
  }
};

/// One set for all lights, each occluder grown by the maximum over them. `receivers` holds every
/// point that will be asked about. Records that cast no shadow are left out. Cost: O(n log n).
ShadowSet build_shadow_set(const RecordTable& records, std::span<const LightHull> lights,
                           Offsets offsets, const Box& receivers);

/// What a query does with an occluder that it tested.
enum class Visit { go_on, stop };

/// Calls visit(record, is_candidate) for the occluders whose boxes the segment from p to the
/// light's centre meets, until it says stop. Candidates are those whose outer offset it may meet:
/// the records that may block a sample. Returns the number of occluders tested.
using VisitOccluder = Visit (*)(void* context, std::uint32_t record, bool is_candidate);
std::uint64_t visit_occluders(const ShadowSet& set, const RecordTable& records,
                              const LightHull& light, Vec3f p, VisitOccluder visit, void* context);

template <class F>
std::uint64_t visit_occluders(const ShadowSet& set, const RecordTable& records,
                              const LightHull& light, Vec3f p, F visit) {
  const auto call = [](void* context, std::uint32_t record, bool is_candidate) {
    return (*static_cast<F*>(context))(record, is_candidate);
  };
  return visit_occluders(set, records, light, p, call, &visit);
}

}  // namespace penumbra
