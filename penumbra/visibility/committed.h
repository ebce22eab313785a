// SPDX-License-Identifier: MIT
// What was committed: never changes, so that questions may be asked of it from any thread.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>

#include "penumbra/geometry/box.h"
#include "penumbra/kernel/kernel.h"
#include "penumbra/shadow/shadow_scene.h"
#include "penumbra/visibility/gather.h"
#include "penumbra/visibility/scratch_pool.h"

namespace penumbra {

struct Committed {
  Committed(Kernel kernel_, OccluderNames names_)
      : kernel(std::move(kernel_)), names(std::move(names_)) {}

  Kernel kernel;
  ShadowScene shadows;  ///< for `shaft`, without lights; refers to the kernel
  OccluderNames names;
  mutable ScratchPool scratch_pool;

  std::size_t memory_bytes() const { return kernel.memory_bytes() + shadows.memory_bytes(); }
};

/// Cost: O(n log n) over all cores.
std::shared_ptr<const Committed> build(GatheredShapes gathered);

/// The same for shapes that have moved since `before`, in linear time; null where others are there
/// (numbers are not given twice, so that names tell).
std::shared_ptr<const Committed> refitted(const Committed& before, GatheredShapes& gathered);

}  // namespace penumbra
