// SPDX-License-Identifier: MIT
// The shadow work of a picture on its own: the questions of visibility that `render` asks, recorded
// once, so that any method, and Embree, can be timed on exactly these, in their order and batches.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "penumbra/kernel/kernel.h"
#include "penumbra/scene/scene.h"
#include "penumbra/shadow/embree_visibility.h"
#include "penumbra/shadow/visibility.h"
#include "penumbra/trace/render.h"

namespace penumbra {

/// Questions that are asked together: see AnsweredBatch.
struct ShadowBatch {
  std::uint64_t path;
  std::uint32_t light;
  std::size_t first, count;  ///< of the work's queries
};

struct ShadowWork {
  std::vector<ShadowQuery> queries;
  std::vector<ShadowBatch> batches;
  std::vector<std::size_t> blocks{0};  ///< first batch of each block, then the number of batches
};

/// All questions of a picture, block by block, in the order of `render`. They do not depend on the
/// number of shadow samples. Cost: that of the picture by method `hard`.
ShadowWork record_shadow_work(const Scene& scene, const Kernel& kernel, RenderOptions options);

/// Every `step`-th block of it.
ShadowWork part_of(const ShadowWork& work, std::size_t step);

/// Answers by a method of ours, for one thread.
class MethodWorker {
 public:
  MethodWorker(const ShadowScene& scene, std::uint32_t shadow_samples)
      : scene_(&scene), scratch_(shadow_samples), cache_(scene.lights.size()) {}
  void begin_block() { cache_ = OccluderCache(scene_->lights.size()); }
  void answer(const ShadowBatch& batch, std::span<const ShadowQuery> queries,
              ShadowCounters& counters, std::span<Visibility> seen) {
    visibilities(*scene_, batch.light, queries, cache_.queue(batch.path, batch.light), scratch_,
                 counters, seen);
  }

 private:
  const ShadowScene* scene_;
  VisibilityScratch scratch_;
  OccluderCache cache_;
};

/// Answers by Embree, for one thread.
class EmbreeWorker {
 public:
  /// `scene` says which lights, and by `hard` whether one ray or `shadow_samples`.
  EmbreeWorker(const EmbreeBaseline& embree, EmbreeVariant variant, const ShadowScene& scene,
               std::uint32_t shadow_samples)
      : embree_(&embree), variant_(variant), scene_(&scene), scratch_(shadow_samples) {}
  void begin_block() {}
  void answer(const ShadowBatch& batch, std::span<const ShadowQuery> queries,
              ShadowCounters& counters, std::span<Visibility> seen) {
    embree_visibilities(*embree_, variant_, *scene_, batch.light, queries, scratch_, counters,
                        seen);
  }

 private:
  const EmbreeBaseline* embree_;
  EmbreeVariant variant_;
  const ShadowScene* scene_;
  EmbreeScratch scratch_;
};

/// What answering took.
struct WorkDone {
  double seconds = 0;  ///< wall time
  ShadowCounters counters;
};

/// Answers all questions, each thread with one of the workers, block by block. `seen` gets the
/// answers; where it is empty, they are dropped.
WorkDone answer_all(const ShadowWork& work, std::span<MethodWorker> workers,
                    std::span<Visibility> seen);
WorkDone answer_all(const ShadowWork& work, std::span<EmbreeWorker> workers,
                    std::span<Visibility> seen);

}  // namespace penumbra
