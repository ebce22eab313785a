// SPDX-License-Identifier: MIT
#include "penumbra/visibility/ask.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "penumbra/kernel/more_threads.h"
#include "penumbra/scene/check_light.h"
#include "penumbra/scene/error.h"
#include "penumbra/shadow/visibility.h"
#include "penumbra/visibility/lights.h"
#include "penumbra/visibility/point_order.h"

namespace penumbra {
namespace {

/// Points that one thread takes at a time, whole tiles: few enough that small calls have blocks for
/// all threads, and a call that is to end does so soon, however many samples a point has.
std::size_t block_size_of(std::uint32_t shadow_samples) {
  constexpr std::size_t tile = 64, most_tiles = 64, most_samples = 1 << 17;
  return tile * std::clamp<std::size_t>(most_samples / tile / shadow_samples, 1, most_tiles);
}

void require_count(const char* what, std::size_t count, std::size_t points) {
  if (count != points)
    throw Error({}, fmt::format("{} {} for {} points", count, what, points),
                "give one a point, or none");
}

void require_room(std::size_t given, std::size_t wanted) {
  if (given != 0 && given != wanted)
    throw Error({}, fmt::format("room for {} answers where {} are to come", given, wanted),
                "give as much");
}

void check(const Points& points, const AskOptions& options, const Answers& answers) {
  const std::size_t count = points.positions.size();
  if (count > std::numeric_limits<std::uint32_t>::max())
    throw Error({}, "more than 2^32 - 1 points", "ask in parts, with a first_key each");
  if (!points.normals.empty()) require_count("normals", points.normals.size(), count);
  if (!points.keys.empty()) require_count("keys", points.keys.size(), count);
  if (points.offset && !(std::abs(*points.offset) <= 1e15f))
    throw Error({}, "the points' offset is not a number within ±1e15", "use 0 for none");
  constexpr std::uint32_t most_threads = 4096;
  require_samples(options.shadow_samples);
  if (options.method != Method::shaft && options.method != Method::stochastic)
    throw Error({}, "occluders are asked by the methods shaft and stochastic alone",
                "use the renderer for the others");
  if (options.threads > most_threads)
    throw Error({}, fmt::format("{} threads", options.threads), "use 0 for all cores");
  require_room(answers.visibility.size(), count);
  require_room(answers.fraction.size(), count);
  require_room(answers.shadow_class.size(), count);
  require_room(answers.free_samples.size(), count * ((options.shadow_samples + 31) / 32));
}

/// The largest coordinate; 0 of nothing.
float farthest(const Box& box) {
  return box.is_empty() ? 0 : std::max(max_abs(box.lo), max_abs(box.hi));
}

bool wants_class_alone(const Answers& answers) {
  return answers.visibility.empty() && answers.fraction.empty() && answers.free_samples.empty();
}

/// Proofs do not depend on how many samples are not taken.
std::uint32_t samples_of(const AskOptions& options, const Answers& answers) {
  constexpr std::uint32_t some = 32;
  return wants_class_alone(answers) && options.method == Method::shaft ? some
                                                                       : options.shadow_samples;
}

/// What the questions of one call share.
class Asker {
 public:
  Asker(const Committed& occluders, const Points& points, const LightShape& light,
        const AskOptions& options, const Answers& answers)
      : occluders_(occluders),
        points_(points),
        light_(light),
        options_(options),
        answers_(answers),
        shadow_samples_(samples_of(options, answers)),
        block_size_(block_size_of(shadow_samples_)),
        farthest_(farthest(occluders.kernel.bounds())) {}

  ShadowCounters ask() {
    if (options_.threads == 0) {
      // Of the caller's own tasks, none is taken up by a thread that waits here.
      tbb::this_task_arena::isolate([&] { answer_all(); });
    } else {
      const MoreThreads allowed(options_.threads);
      tbb::task_arena(static_cast<int>(options_.threads)).execute([&] { answer_all(); });
    }
    if (is_cancelled_) throw Cancelled();
    return counters_;
  }

 private:
  void answer_all() {
    const std::size_t blocks = (points_.positions.size() + block_size_ - 1) / block_size_;
    if (blocks > 1) order_ = order_of(points_.positions);
    if (blocks == 1) return answer_block(0);
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, blocks, 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t i = range.begin(); i < range.end(); ++i) answer_block(i);
        },
        tbb::simple_partitioner());
  }

  void answer_block(std::size_t block) {
    if (is_cancelled_) return;
    std::unique_ptr<AskScratch> own = occluders_.scratch_pool.take(shadow_samples_);
    AskScratch& scratch = *own;
    const std::size_t first = block * block_size_;
    const std::size_t count = std::min(block_size_, points_.positions.size() - first);
    scratch.queries.resize(count);
    Box box;
    for (std::size_t i = 0; i < count; ++i) {
      const ShadowQuery& query = scratch.queries[i] = query_of(point_at(first + i));
      if (is_near(query.receiver.position)) box.add(query.receiver.position);
    }
    // What cannot be proven far away must not be lost for others.
    const ShadowScene scene = with_light(occluders_.shadows, light_, options_.method, box);
    OccluderQueue queue;
    const AnswerRows rows = rows_in(scratch);
    ShadowCounters counters;
    visibilities(scene, 0, scratch.queries, queue, scratch.visibility, counters, rows);
    for (std::size_t i = 0; i < count; ++i) put(point_at(first + i), rows, i);
    occluders_.scratch_pool.give_back(std::move(own));
    report(count, counters);
  }

  /// Whether float can tell anything of the occluders there.
  bool is_near(Vec3f p) const {
    constexpr float most = 1000;
    return is_finite(p) && (farthest_ == 0 || max_abs(p) <= most * farthest_);
  }

  /// The caller's number of the point that is asked about as the i-th.
  std::size_t point_at(std::size_t i) const { return order_.empty() ? i : order_[i]; }

  AnswerRows rows_in(AskScratch& scratch) const {
    scratch.seen.resize(scratch.queries.size());
    AnswerRows rows{.seen = scratch.seen, .shadow_samples = shadow_samples_};
    if (wants_class_alone(answers_)) rows.wanted = Wanted::shadow_class;
    if (!answers_.free_samples.empty()) {
      scratch.free_samples.resize(rows.seen.size() * rows.words());
      rows.free_samples = scratch.free_samples;
    }
    return rows;
  }

  void put(std::size_t point, const AnswerRows& rows, std::size_t i) const {
    if (!answers_.visibility.empty()) answers_.visibility[point] = rows.seen[i];
    if (!answers_.fraction.empty()) answers_.fraction[point] = rows.seen[i].fraction;
    if (!answers_.shadow_class.empty()) answers_.shadow_class[point] = rows.seen[i].shadow_class;
    for (std::size_t word = 0; word < rows.words() && !rows.free_samples.empty(); ++word)
      answers_.free_samples[point * rows.words() + word] =
          rows.free_samples[i * rows.words() + word];
  }

  ShadowQuery query_of(std::size_t i) const {
    const Vec3f position = points_.positions[i];
    const Vec3f normal = points_.normals.empty() ? Vec3f{} : receiver_normal(points_.normals[i]);
    const float offset =
        points_.offset ? *points_.offset : 0x1p-17f * std::max(farthest_, max_abs(position));
    const std::uint64_t key = points_.keys.empty() ? points_.first_key + i : points_.keys[i];
    return {{offset != 0 ? position + normal * offset : position, normal},
            options_.light_index ? light_key(key, *options_.light_index) : key};
  }

  void report(std::size_t count, const ShadowCounters& counters) {
    const std::lock_guard lock(mutex_);
    counters_.add(counters);
    done_ += count;
    if (!options_.progress || is_cancelled_) return;
    const double share = static_cast<double>(done_) / static_cast<double>(points_.positions.size());
    try {
      // Where it waits for tasks of its own, none of ours is taken up, which would come back here.
      if (!tbb::this_task_arena::isolate([&] { return options_.progress(share); }))
        is_cancelled_ = true;
    } catch (...) {
      is_cancelled_ = true;  // it is not called again
      throw;
    }
  }

  const Committed& occluders_;
  const Points& points_;
  const LightShape& light_;
  const AskOptions& options_;
  const Answers& answers_;
  std::uint32_t shadow_samples_;
  std::size_t block_size_;
  float farthest_;                    // coordinate of the occluders
  std::vector<std::uint32_t> order_;  // empty: points are asked about as they come
  std::mutex mutex_;
  ShadowCounters counters_;
  std::size_t done_ = 0;
  std::atomic<bool> is_cancelled_ = false;
};

}  // namespace

void require_samples(std::uint32_t shadow_samples) {
  constexpr std::uint32_t most_samples = 65536;
  if (shadow_samples < 1 || shadow_samples > most_samples)
    throw Error({}, fmt::format("{} shadow samples", shadow_samples), "use 1 to 65536");
}

ShadowCounters ask(const Committed& occluders, const Points& points, const LightShape& light,
                   const AskOptions& options, const Answers& answers) {
  check(points, options, answers);
  return Asker(occluders, points, checked_light(occluders, light), options, answers).ask();
}

LightShape checked_light(const Committed& occluders, LightShape light) {
  const double extent = occluders.kernel.bounds().largest_extent();
  if (extent > 0 && is_too_large(light, extent))
    throw Error({}, "the light is more than a million times as large as the occluders",
                "use a sun, or a ball");
  return checked_light(std::move(light));
}

Vec3f receiver_normal(Vec3f normal) { return is_finite(normal) ? unit(normal) : normal; }

}  // namespace penumbra
