// SPDX-License-Identifier: MIT
#include "penumbra/visibility/blockers.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "penumbra/shadow/hull_proof.h"
#include "penumbra/shadow/shaft.h"
#include "penumbra/shadow/sift.h"
#include "penumbra/shadow/visibility.h"

namespace penumbra {
namespace {

/// What the proofs of one question look at.
struct Question {
  ShadowScene scene;
  std::vector<ShadowQuery> queries;  ///< the receiver, or the box's corners
  Box box;
};

/// As all of the queries see the light: if nothing can be proven of them, nothing is left out.
struct Sight {
  SeenLight seen;
  bool is_certain = false;
};

Sight sight_of(const Question& question) {
  ReceiverRows rows;
  const ReceiverBits bits =
      see_light(question.scene.forms[0], question.queries, question.scene.receivers, rows);
  const std::size_t count = question.queries.size();
  const std::uint64_t all = (1ull << count) - 1;
  if (count == 1) return {seen_by_one(question.scene.forms[0], rows, 0), (bits.certain & 1) != 0};
  const ReceiverGroup group{rows, 0, count, (bits.above & all) == all};
  Sight sight{seen_by_all(question.scene.forms[0], group), (bits.certain & all) == all};
  sight.is_certain &= is_apart(sight.seen);
  return sight;
}

/// Records that may block, gathered leaf by leaf and sifted whenever a list is full.
class Gatherer {
 public:
  explicit Gatherer(const Question& question) : question_(question), sight_(sight_of(question)) {}

  std::vector<std::uint32_t> gather() {
    const Kernel& kernel = *question_.scene.kernel;
    if (kernel.tree().nodes.empty()) return {};
    walk(kernel.tree(), bounds(), [&](std::span<const Record> records, std::uint32_t first) {
      for (std::uint32_t i = 0; i < records.size(); ++i) {
        if (!sight_.is_certain)
          found_.push_back(first + i);
        else
          list_->add(records[i], first + i);
      }
      if (list_->size() + NodeRef::most_records > CandidateList::most) sift_list();
      return false;
    });
    sift_list();
    return std::move(found_);
  }

 private:
  ShaftBounds bounds() const {
    ShaftBounds bounds = shaft_bounds(question_.scene, 0, question_.box, sight_.seen);
    if (!sight_.is_certain) bounds.up = {}, bounds.floor = ShaftBounds{}.floor;
    return bounds;
  }

  void sift_list() {
    if (question_.queries.size() == 1) {
      sift(*list_, sight_.seen, sifted_);
      found_.insert(found_.end(), sifted_.record.begin(), sifted_.record.end());
      if (sifted_.cover != no_record) keep_all(*list_);
    } else if (sift_for_all(*list_, sight_.seen, *kept_) == no_record) {
      keep_all(*kept_);
    } else {
      keep_all(*list_);
    }
    list_->clear();
  }

  /// Where one covers, the sift ends early: all that were on the list may block.
  void keep_all(const CandidateList& list) {
    const auto keep = [&](const auto& rows) {
      found_.insert(found_.end(), rows.index, rows.index + rows.count);
    };
    keep(list.spheres), keep(list.rings), keep(list.cones), keep(list.triangles);
  }

  const Question& question_;
  Sight sight_;
  std::unique_ptr<CandidateList> list_ = std::make_unique<CandidateList>(),
                                 kept_ = std::make_unique<CandidateList>();
  Sifted sifted_;
  std::vector<std::uint32_t> found_;
};

/// The names of what may block, in rising order, each once.
std::vector<PrimitiveId> names_of(const Committed& occluders,
                                  const std::vector<std::uint32_t>& records) {
  std::vector<PrimitiveId> names;
  for (const std::uint32_t record : records)
    names.push_back(name_of(occluders.names, occluders.kernel.shape(record)));
  const auto rank = [](const PrimitiveId& id) {
    return std::tuple(id.instance != PrimitiveId::no_instance, id.instance, id.geometry,
                      id.primitive);
  };
  std::sort(names.begin(), names.end(),
            [&](const PrimitiveId& a, const PrimitiveId& b) { return rank(a) < rank(b); });
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

constexpr std::uint32_t samples_worth_all_proofs = 256;

Blockers answer(const Committed& occluders, const Question& question, ShadowClass shadow_class) {
  if (shadow_class == ShadowClass::lit) return {shadow_class, {}};
  return {shadow_class, names_of(occluders, Gatherer(question).gather())};
}

}  // namespace

Blockers blockers_of_point(const Committed& occluders, const Receiver& receiver,
                           const LightShape& light) {
  const Box box{receiver.position, receiver.position};
  const Question question{
      with_light(occluders.shadows, light, Method::shaft, box), {{receiver, 0}}, box};
  auto scratch = occluders.scratch_pool.take(samples_worth_all_proofs);
  OccluderQueue queue;
  ShadowCounters counters;
  Visibility seen;
  visibilities(question.scene, 0, question.queries, queue, scratch->visibility, counters,
               AnswerRows{.seen = {&seen, 1}, .wanted = Wanted::shadow_class});
  occluders.scratch_pool.give_back(std::move(scratch));
  return answer(occluders, question, seen.shadow_class);
}

Blockers blockers_of_box(const Committed& occluders, const Box& box, const LightShape& light) {
  Question question{with_light(occluders.shadows, light, Method::shaft, box), {}, box};
  std::array<Receiver, 8> corners;
  for (int i = 0; i < 8; ++i)
    corners[i].position = {i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y,
                           i & 4 ? box.hi.z : box.lo.z};
  for (const Receiver& corner : corners) question.queries.push_back({corner, 0});
  auto scratch = occluders.scratch_pool.take(samples_worth_all_proofs);
  OccluderQueue queue;
  ShadowCounters counters;
  const HullProof proof =
      prove_hull(question.scene, 0, corners, queue, scratch->visibility, counters);
  occluders.scratch_pool.give_back(std::move(scratch));
  return answer(occluders, question, proof.shadow_class);
}

}  // namespace penumbra
