// SPDX-License-Identifier: MIT
#include "penumbra/shadow/tile.h"

#include <algorithm>
#include <bit>

#include "penumbra/kernel/kernel.h"
#include "penumbra/shadow/cover.h"
#include "penumbra/shadow/hull_proof.h"
#include "penumbra/shadow/offset.h"
#include "penumbra/shadow/shaft.h"
#include "penumbra/shadow/sheet_proof.h"
#include "penumbra/shadow/spatial_order.h"

namespace penumbra {
namespace {

// All of these trade one cost for another (docs/performance.md); none changes an answer.

/// Records that are worth gathering: for groups, and for single receivers.
constexpr std::size_t most_of(std::size_t receivers) {
  return receivers > 16 ? 256 : receivers > 4 ? 96 : 48;
}
constexpr std::size_t most_of_one = 40;
static_assert(most_of(ReceiverRows::most) <= CandidateList::most);
/// Candidates so few that a group is not split any more.
constexpr std::size_t listed = 32;
/// Candidates of one receiver so few that double precision looks at each.
constexpr std::size_t looked_at = 6;
/// Candidates so many that every word of samples sifts them again.
constexpr std::size_t worth_words = 6;
/// Candidates that 32 samples are held against sooner than go down the hierarchy.
constexpr std::size_t worth_list = 14;

/// Triangles of a sheet that a proof is worth, for each sample that it saves; and from how many
/// samples on it is worth to be asked for a single receiver.
constexpr std::size_t sheet_a_sample = 2, samples_worth_a_sheet = 128;

/// The class of what is not sampled, where that is all that is wanted.
constexpr Visibility unproven{0, 0, ShadowClass::penumbra};

/// One tile; a class because all steps share these references.
class Tile {
 public:
  Tile(const ShadowScene& scene, std::uint32_t light, std::span<const ShadowQuery> queries,
       OccluderQueue& queue, SampleScratch& samples, TileScratch& scratch, ShadowCounters& counters,
       const AnswerRows& answers)
      : scene_(scene),
        form_(scene.forms[light]),
        light_(light),
        queries_(queries),
        queue_(queue),
        samples_(samples),
        scratch_(scratch),
        counters_(counters),
        answers_(answers) {}

  void answer() {
    const ReceiverBits bits = see_light(form_, queries_, scene_.receivers, scratch_.rows);
    std::uint64_t pending = 0;
    for (std::size_t i = 0; i < queries_.size(); ++i) {
      const std::uint64_t bit = 1ull << i;
      // In doubt: p' in the light, far outside the scene, or no number.
      if (!(bits.certain & bit) && !((bits.near & bit) && is_outside_light(i)))
        answers_.put(i, by_packets(i, ShadowClass::penumbra), samples_);
      else if (bits.below & bit)
        answers_.put(i, {0, 0, ShadowClass::umbra}, samples_);
      else
        pending |= bit;
    }
    if (pending == 0) return;
    above_ = 0;
    std::size_t row = 0;
    for (std::uint64_t rest = pending; rest != 0; rest &= rest - 1, ++row) {
      scratch_.query[row] = static_cast<std::uint32_t>(std::countr_zero(rest));
      above_ |= (bits.above >> scratch_.query[row] & 1) << row;
    }
    keep_rows(pending, scratch_.rows);
    answer_group(0, row, nullptr, 0);
  }

  HullProof prove_all() {
    const ReceiverBits bits = see_light(form_, queries_, scene_.receivers, scratch_.rows);
    const std::uint64_t all = bits_below(queries_.size());
    if ((bits.certain & all) != all) return {};
    if ((bits.below & all) == all) return {ShadowClass::umbra, false};
    above_ = bits.above;
    const ReceiverGroup receivers = group(0, queries_.size());
    const SeenLight sight = seen_by_all(form_, receivers);
    if (!is_apart(sight)) return {};
    ++counters_.set_rays;
    if (gather_candidates(scene_, light_, receivers.bounds(), sight, CandidateList::most,
                          gathered(), counters_.set_tests)) {
      CandidateList& list = scratch_.list[TileScratch::of_groups];
      if (sift_for_all(gathered(), sight, list) != no_record)
        return {ShadowClass::umbra, receivers.are_above};
      if (list.size() == 0) return {ShadowClass::lit, receivers.are_above};
      if (list.triangles.count == 0) return {ShadowClass::penumbra, receivers.are_above};
    }
    const bool is_umbra = !scene_.sheet->is_empty() && is_behind_sheet(sight, ReceiverRows::most);
    return {is_umbra ? ShadowClass::umbra : ShadowClass::penumbra, receivers.are_above};
  }

 private:
  static std::uint64_t bits_below(std::size_t count) {
    return count >= 64 ? ~0ull : (1ull << count) - 1;
  }
  ReceiverGroup group(std::size_t first, std::size_t count) const {
    const std::uint64_t bits = bits_below(count) << first;
    return {scratch_.rows, first, count, (above_ & bits) == bits};
  }

  /// `parent`: candidates of a larger group, or null where they were too many.
  void answer_group(std::size_t first, std::size_t count, const CandidateList* parent,
                    std::size_t level) {
    if (count == 1) return answer_one(first, parent);
    const ReceiverGroup receivers = group(first, count);
    const SeenLight sight = seen_by_all(form_, receivers);
    const bool is_gathered = !parent && gather(receivers, sight, most_of(count));
    if (is_gathered) parent = &gathered();
    CandidateList* list = nullptr;
    if (parent) {
      list = &scratch_.list[TileScratch::of_groups + level];
      if (sift_for_all(*parent, sight, *list) != no_record)
        return all_are(first, count, ShadowClass::umbra);
      if (is_gathered) queue_.list[level_of(count)].note(list->size() <= most_of(count) / 4);
      if (list->size() == 0) return all_are(first, count, ShadowClass::lit);
    }
    // Without triangles there are no sheets.
    const bool may_have_sheet = !scene_.sheet->is_empty() && !(list && list->triangles.count == 0);
    if (may_have_sheet && tries_sheet(sight, count))
      return all_are(first, count, ShadowClass::umbra);
    if (list && list->size() <= listed) return answer_each(receivers, *list);
    const std::size_t part = (count + 3) / 4;
    for (std::size_t from = 0; from < count; from += part)
      answer_group(first + from, std::min(part, count - from), list, level + 1);
  }

  CandidateList& gathered() { return scratch_.list[TileScratch::gathered]; }

  bool gather(const ReceiverGroup& receivers, const SeenLight& sight, std::size_t most) {
    Backoff& backoff = queue_.list[level_of(receivers.count)];
    if (!backoff.is_due()) return false;
    ++counters_.set_rays;
    const bool is_list = gather_candidates(scene_, light_, receivers.bounds(), sight, most,
                                           gathered(), counters_.set_tests);
    if (!is_list) backoff.note(false);
    return is_list;
  }

  static std::size_t level_of(std::size_t count) {
    return count > 16 ? 0 : count > 4 ? 1 : count > 1 ? 2 : 3;
  }

  /// Candidates are few: each is held against all receivers.
  void answer_each(const ReceiverGroup& receivers, const CandidateList& list) {
    SiftedRows& sifted = scratch_.sifted_rows;
    sift_rows(list, form_, receivers, sifted);
    for (std::size_t i = 0; i < receivers.count; ++i) {
      const std::size_t row = receivers.first + i;
      if (sifted.covered >> i & 1) {
        put(row, proven(row, ShadowClass::umbra));
      } else if (!(sifted.kept >> i & 1)) {
        put(row, proven(row, ShadowClass::lit));
      } else {
        std::vector<std::uint32_t>& records = scratch_.sifted.record;
        records.clear();
        for (const SiftedRows::Candidate& candidate : sifted.candidate)
          if (candidate.kept >> i & 1) records.push_back(candidate.record);
        put(row, by_records(row));
      }
    }
  }

  void put(std::size_t row, const Visibility& answer) {
    answers_.put(scratch_.query[row], answer, samples_);
  }

  bool tries_sheet(const SeenLight& sight, std::size_t receivers) {
    Backoff& backoff = queue_.sheet[level_of(receivers)];
    if (!backoff.is_due()) return false;
    const bool is_umbra = is_behind_sheet(sight, receivers);
    backoff.note(is_umbra);
    return is_umbra;
  }

  bool is_behind_sheet(const SeenLight& sight, std::size_t receivers) {
    const std::size_t samples = wants_class() ? samples_worth_a_sheet : samples_.pattern.size();
    const auto most = static_cast<std::uint32_t>(
        std::min<std::size_t>(sheet_a_sample * samples * receivers, SheetScratch::most));
    return penumbra::is_behind_sheet(scene_, sight, most, scratch_.outline, scratch_.sheet,
                                     counters_.set_tests);
  }

  /// A proof for all of a group. Where a light straddles the horizon, samples have a say still.
  void all_are(std::size_t first, std::size_t count, ShadowClass shadow_class) {
    for (std::size_t row = first; row < first + count; ++row) put(row, proven(row, shadow_class));
  }

  Visibility proven(std::size_t row, ShadowClass shadow_class) {
    const bool is_above = above_ >> row & 1;
    if (!is_above && !take(scratch_.query[row])) return {0, 0, ShadowClass::umbra};
    counters_.count(shadow_class);
    if (shadow_class == ShadowClass::umbra) return {0, 0, shadow_class};
    return is_above || wants_class() ? Visibility{1, 1, shadow_class} : summed(shadow_class, 0);
  }

  void answer_one(std::size_t row, const CandidateList* list) {
    const SeenLight seen = seen_by_one(form_, scratch_.rows, row);
    const bool is_gathered = !list && gather(group(row, 1), seen, most_of_one);
    if (is_gathered) list = &gathered();
    const bool may_have_sheet = !scene_.sheet->is_empty() &&
                                (samples_.pattern.size() >= samples_worth_a_sheet || wants_class());
    if (!list) {
      const bool is_umbra = may_have_sheet && tries_sheet(seen, 1);
      return put(row, is_umbra ? proven(row, ShadowClass::umbra)
                               : by_packets(scratch_.query[row], ShadowClass::umbra));
    }
    sift(*list, seen, scratch_.sifted);
    if (is_gathered) queue_.list[level_of(1)].note(scratch_.sifted.record.size() <= worth_list);
    if (scratch_.sifted.cover != no_record)
      put(row, proven(row, ShadowClass::umbra));
    else if (scratch_.sifted.record.empty())
      put(row, proven(row, ShadowClass::lit));
    else
      put(row, by_records(row));
  }

  bool wants_class() const { return answers_.wanted == Wanted::shadow_class; }

  /// Takes the samples of query i; returns whether any is above the horizon. Where the class is all
  /// that is wanted, none are taken: it holds for all of the light, and some of it may be above.
  bool take(std::size_t i) {
    if (wants_class()) return true;
    const ShadowQuery& query = queries_[i];
    return take_samples(scene_, light_, query.receiver, query.key, samples_) > 0;
  }

  /// What double precision proves of a few cones, rings and triangles: that they lie behind the
  /// receiver's horizon, or hide the whole light.
  ShadowClass look_closely(std::size_t row) {
    std::vector<std::uint32_t>& few_records = scratch_.sifted.record;
    if (few_records.size() > looked_at || !queue_.closely.is_due()) return ShadowClass::penumbra;
    const Vec3f p = queries_[scratch_.query[row]].receiver.position;
    const LightHull& light = scene_.hulls[light_];
    const RecordTable records = scene_.kernel->records();
    Record room;
    std::erase_if(few_records, [&](std::uint32_t i) {
      const Record& record = records.get(i, room);
      return record.kind != ShapeKind::sphere && surely_behind_horizon(record, light, p);
    });
    const bool is_covered =
        std::any_of(few_records.begin(), few_records.end(), [&](std::uint32_t i) {
          const Record& record = records.get(i, room);
          return record.kind != ShapeKind::sphere && surely_covers(record, light, p);
        });
    queue_.closely.note(is_covered || few_records.empty());
    return is_covered            ? ShadowClass::umbra
           : few_records.empty() ? ShadowClass::lit
                                 : ShadowClass::penumbra;
  }

  /// By the sifted records, what blocked last first. Where they and the samples are many, runs of
  /// samples, which are neighbours on the light, sift them again.
  Visibility by_records(std::size_t row) {
    const ShadowClass proof = look_closely(row);
    if (proof != ShadowClass::penumbra) return proven(row, proof);
    if (wants_class() && !scene_.sheet->is_empty() &&
        is_behind_sheet(seen_by_one(form_, scratch_.rows, row), 1))
      return proven(row, ShadowClass::umbra);
    if (!take(scratch_.query[row])) return {0, 0, ShadowClass::umbra};
    counters_.count(ShadowClass::penumbra);
    if (wants_class()) return unproven;
    std::vector<std::uint32_t>& records = scratch_.sifted.record;
    const auto last = std::find(records.begin(), records.end(), queue_.record[0]);
    if (last != records.end()) std::iter_swap(last, records.begin());
    std::uint64_t rays = 0;
    if (samples_.active.size() < 2 || records.size() < worth_words) {
      rays = records.size() > worth_list
                 ? trace_samples(*scene_.kernel, queue_, samples_, counters_)
                 : trace_samples(*scene_.kernel, records, queue_, samples_, counters_);
      return summed(ShadowClass::penumbra, rays);
    }
    CandidateList& list = scratch_.list[TileScratch::of_one];
    list.clear();
    for (const std::uint32_t i : records) list.add(scene_.kernel->records()[i], i);
    const SeenLight seen = seen_by_one(form_, scratch_.rows, row);
    for (std::uint32_t word = 0; word < samples_.active.size(); ++word) {
      if (samples_.active[word] == 0) continue;
      sift(list, seen_part(seen, samples_.samples, word, samples_.active[word]), scratch_.sifted);
      if (scratch_.sifted.cover != no_record) records.assign(1, scratch_.sifted.cover);
      if (!records.empty())
        rays += trace_word(*scene_.kernel, records, word, queue_, samples_, counters_);
    }
    return summed(ShadowClass::penumbra, rays);
  }

  /// Nothing is proven. `unseen`: the class where no sample is above the horizon.
  Visibility by_packets(std::size_t i, ShadowClass unseen) {
    if (!take(i)) return {0, 0, unseen};
    counters_.count(ShadowClass::penumbra);
    if (wants_class()) return unproven;
    return summed(ShadowClass::penumbra,
                  trace_samples(*scene_.kernel, queue_, samples_, counters_));
  }

  bool is_outside_light(std::size_t i) const {
    return !contains(scene_.lights[light_], queries_[i].receiver.position);
  }

  Visibility summed(ShadowClass shadow_class, std::uint64_t rays) {
    Visibility result = sum_up(samples_);
    result.shadow_class = shadow_class;
    result.rays = static_cast<std::uint32_t>(rays);
    return result;
  }

  const ShadowScene& scene_;
  const LightForm& form_;
  std::uint32_t light_;
  std::span<const ShadowQuery> queries_;
  OccluderQueue& queue_;
  SampleScratch& samples_;
  TileScratch& scratch_;
  ShadowCounters& counters_;
  AnswerRows answers_;
  std::uint64_t above_ = 0;  // rows that see the whole light above their horizon
};

}  // namespace

void answer_by_tiles(const ShadowScene& scene, std::uint32_t light,
                     std::span<const ShadowQuery> queries, OccluderQueue& queue,
                     SampleScratch& samples, TileScratch& scratch, ShadowCounters& counters,
                     const AnswerRows& answers) {
  constexpr std::size_t most = ReceiverRows::most;
  const auto answer = [&](std::span<const ShadowQuery> from, const AnswerRows& to) {
    for (std::size_t first = 0; first < from.size(); first += most) {
      const std::size_t count = std::min(most, from.size() - first);
      Tile(scene, light, from.subspan(first, count), queue, samples, scratch, counters,
           to.part(first, count))
          .answer();
    }
  };
  if (!is_scattered(queries, most)) return answer(queries, answers);
  order_in_space(queries, scratch.order);
  scratch.ordered.clear();
  for (const std::uint32_t i : scratch.order) scratch.ordered.push_back(queries[i]);
  AnswerRows ordered = answers;
  scratch.answers.resize(queries.size());
  scratch.free_samples.resize(answers.free_samples.size());
  ordered.seen = scratch.answers, ordered.free_samples = scratch.free_samples;
  answer(scratch.ordered, ordered);
  for (std::size_t i = 0; i < queries.size(); ++i) answers.copy(scratch.order[i], ordered, i);
}

HullProof prove_hull(const ShadowScene& scene, std::uint32_t light,
                     std::span<const Receiver> corners, OccluderQueue& queue,
                     VisibilityScratch& scratch, ShadowCounters& counters) {
  if (scene.method != Method::shaft || is_point(scene.lights[light]) || corners.empty() ||
      corners.size() > ReceiverRows::most)
    return {};
  std::array<ShadowQuery, ReceiverRows::most> queries;
  for (std::size_t i = 0; i < corners.size(); ++i) queries[i] = {corners[i]};
  return Tile(scene, light, std::span(queries).first(corners.size()), queue, scratch.samples,
              scratch.tile, counters, {})
      .prove_all();
}

}  // namespace penumbra
