// SPDX-License-Identifier: MIT
#include "penumbra/trace/shadow_work.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

#include "penumbra/kernel/more_threads.h"
#include "penumbra/trace/clock.h"
#include "penumbra/trace/prepare.h"

namespace penumbra {
namespace {

void append(const ShadowWork& work, std::size_t block, ShadowWork& to) {
  for (std::size_t b = work.blocks[block]; b < work.blocks[block + 1]; ++b) {
    const ShadowBatch& batch = work.batches[b];
    const auto from = work.queries.begin() + static_cast<std::ptrdiff_t>(batch.first);
    to.batches.push_back({batch.path, batch.light, to.queries.size(), batch.count});
    to.queries.insert(to.queries.end(), from, from + static_cast<std::ptrdiff_t>(batch.count));
  }
  to.blocks.push_back(to.batches.size());
}

/// What one thread needs beside its worker; apart from other threads' in memory.
struct alignas(128) Desk {
  ShadowCounters counters;
  std::vector<Visibility> seen;
};

template <class Worker>
void answer_block(const ShadowWork& work, std::size_t block, Worker& worker, Desk& desk,
                  std::span<Visibility> seen) {
  worker.begin_block();
  for (std::size_t b = work.blocks[block]; b < work.blocks[block + 1]; ++b) {
    const ShadowBatch& batch = work.batches[b];
    worker.answer(batch, std::span(work.queries).subspan(batch.first, batch.count), desk.counters,
                  seen.empty() ? std::span(desk.seen).first(batch.count)
                               : seen.subspan(batch.first, batch.count));
  }
}

template <class Worker>
WorkDone answer_by(const ShadowWork& work, std::span<Worker> workers, std::span<Visibility> seen) {
  std::size_t longest = 0;
  for (const ShadowBatch& batch : work.batches) longest = std::max(longest, batch.count);
  std::vector<Desk> desks(workers.size());
  for (Desk& desk : desks) desk.seen.resize(longest);
  const std::size_t blocks = work.blocks.size() - 1;
  const MoreThreads allowed(workers.size());
  tbb::task_arena arena(static_cast<int>(workers.size()));
  arena.initialize();

  WorkDone done;
  const double start = now_seconds();
  if (workers.size() == 1) {
    for (std::size_t i = 0; i < blocks; ++i) answer_block(work, i, workers[0], desks[0], seen);
  } else {
    arena.execute([&] {
      tbb::parallel_for(
          tbb::blocked_range<std::size_t>(0, blocks, 1),
          [&](const tbb::blocked_range<std::size_t>& range) {
            const auto self =
                static_cast<std::size_t>(tbb::this_task_arena::current_thread_index());
            for (std::size_t i = range.begin(); i < range.end(); ++i)
              answer_block(work, i, workers[self], desks[self], seen);
          },
          tbb::simple_partitioner());
    });
  }
  done.seconds = now_seconds() - start;
  for (const Desk& desk : desks) done.counters.add(desk.counters);
  return done;
}

}  // namespace

ShadowWork record_shadow_work(const Scene& scene, const Kernel& kernel, RenderOptions options) {
  std::map<std::uint32_t, ShadowWork> recorded;  // by block
  std::mutex mutex;
  options.shadow_samples = 1;
  options.aovs.clear();
  options.observe = [&](const AnsweredBatch& batch) {
    ShadowWork* work = nullptr;
    {
      const std::lock_guard lock(mutex);
      work = &recorded[batch.block];
    }
    work->batches.push_back({batch.path, batch.light, work->queries.size(), batch.queries.size()});
    work->queries.insert(work->queries.end(), batch.queries.begin(), batch.queries.end());
  };
  render(scene, prepare_shadows(scene, kernel, Method::hard), options);
  ShadowWork all;
  for (auto& [block, work] : recorded) {
    work.blocks.push_back(work.batches.size());
    append(work, 0, all);
  }
  return all;
}

ShadowWork part_of(const ShadowWork& work, std::size_t step) {
  ShadowWork part;
  for (std::size_t block = 0; block + 1 < work.blocks.size(); block += step)
    append(work, block, part);
  return part;
}

WorkDone answer_all(const ShadowWork& work, std::span<MethodWorker> workers,
                    std::span<Visibility> seen) {
  return answer_by(work, workers, seen);
}

WorkDone answer_all(const ShadowWork& work, std::span<EmbreeWorker> workers,
                    std::span<Visibility> seen) {
  return answer_by(work, workers, seen);
}

}  // namespace penumbra
