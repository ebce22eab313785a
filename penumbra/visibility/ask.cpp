// SPDX-License-Identifier: MIT
#include "penumbra/visibility/ask.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "penumbra/scene/check_light.h"
#include "penumbra/scene/error.h"
#include "penumbra/shadow/visibility.h"
#include "penumbra/visibility/lights.h"

namespace penumbra {
namespace {

/// Points that one thread takes at a time: enough for those that are scattered to find neighbours.
constexpr std::size_t block_size = 16384;

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
        scratch_([&] { return Scratch(options.shadow_samples); }) {}

  ShadowCounters ask() {
    const std::size_t blocks = (points_.positions.size() + block_size - 1) / block_size;
    if (blocks < 2 || options_.threads == 1) {
      for (std::size_t i = 0; i < blocks; ++i) answer_block(i);
    } else if (options_.threads == 0) {
      answer_all(blocks);
    } else {
      // More threads than cores must be possible: results are promised for any number.
      const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                        options_.threads);
      tbb::task_arena(static_cast<int>(options_.threads)).execute([&] { answer_all(blocks); });
    }
    if (is_cancelled_) throw Cancelled();
    ShadowCounters sum;
    for (const Scratch& scratch : scratch_) sum.add(scratch.counters);
    return sum;
  }

 private:
  struct Scratch {
    explicit Scratch(std::uint32_t shadow_samples) : visibility(shadow_samples) {}
    VisibilityScratch visibility;
    std::vector<ShadowQuery> queries;
    std::vector<Visibility> seen;
    ShadowCounters counters;
  };

  void answer_all(std::size_t blocks) {
    // Of the caller's own tasks, none is taken up by a thread that waits here.
    tbb::this_task_arena::isolate([&] {
      tbb::parallel_for(
          tbb::blocked_range<std::size_t>(0, blocks, 1),
          [&](const tbb::blocked_range<std::size_t>& range) {
            for (std::size_t i = range.begin(); i < range.end(); ++i) answer_block(i);
          },
          tbb::simple_partitioner());
    });
  }

  void answer_block(std::size_t block) {
    if (is_cancelled_) return;
    Scratch& scratch = scratch_.local();
    const std::size_t first = block * block_size;
    const std::size_t count = std::min(block_size, points_.positions.size() - first);
    scratch.queries.resize(count);
    Box box;
    for (std::size_t i = 0; i < count; ++i) {
      const ShadowQuery& query = scratch.queries[i] = query_of(first + i);
      if (is_finite(query.receiver.position)) box.add(query.receiver.position);
    }
    // What cannot be proven far away must not be lost for others: each block has bounds of its own.
    const ShadowScene scene = with_light(occluders_.shadows, light_, options_.method, box);
    OccluderQueue queue;
    scratch.seen.resize(count);
    visibilities(scene, 0, scratch.queries, queue, scratch.visibility, scratch.counters,
                 rows(first, scratch.seen));
    put(first, scratch.seen);
    report(count);
  }

  AnswerRows rows(std::size_t first, std::span<Visibility> seen) const {
    AnswerRows rows{.seen = seen, .shadow_samples = options_.shadow_samples};
    if (answers_.visibility.empty() && answers_.fraction.empty() && answers_.free_samples.empty())
      rows.wanted = Wanted::shadow_class;
    if (!answers_.free_samples.empty())
      rows.free_samples =
          answers_.free_samples.subspan(first * rows.words(), seen.size() * rows.words());
    return rows;
  }

  void put(std::size_t first, std::span<const Visibility> seen) const {
    const auto put_each = [&](auto rows, auto value) {
      if (!rows.empty())
        std::transform(seen.begin(), seen.end(), rows.begin() + static_cast<std::ptrdiff_t>(first),
                       value);
    };
    put_each(answers_.visibility, [](const Visibility& v) { return v; });
    put_each(answers_.fraction, [](const Visibility& v) { return v.fraction; });
    put_each(answers_.shadow_class, [](const Visibility& v) { return v.shadow_class; });
  }

  ShadowQuery query_of(std::size_t i) const {
    const Vec3f position = points_.positions[i];
    const Vec3f normal = points_.normals.empty() ? Vec3f{} : unit(points_.normals[i]);
    const float offset = points_.offset ? *points_.offset : automatic_offset(occluders_, position);
    const std::uint64_t key = points_.keys.empty() ? points_.first_key + i : points_.keys[i];
    return {{offset != 0 ? position + normal * offset : position, normal},
            options_.light_index ? light_key(key, *options_.light_index) : key};
  }

  void report(std::size_t count) {
    if (!options_.progress) return;
    const std::lock_guard lock(mutex_);
    done_ += count;
    if (is_cancelled_) return;
    if (!options_.progress(static_cast<double>(done_) /
                           static_cast<double>(points_.positions.size())))
      is_cancelled_ = true;
  }

  const Committed& occluders_;
  const Points& points_;
  const LightShape& light_;
  const AskOptions& options_;
  const Answers& answers_;
  tbb::enumerable_thread_specific<Scratch> scratch_;
  std::mutex mutex_;
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

float automatic_offset(const Committed& occluders, Vec3f position) {
  const Box box = occluders.kernel.bounds();
  const float far = box.is_empty() ? 0 : std::max(max_abs(box.lo), max_abs(box.hi));
  return 0x1p-17f * std::max(far, max_abs(position));
}

}  // namespace penumbra
