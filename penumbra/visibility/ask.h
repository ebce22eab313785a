// SPDX-License-Identifier: MIT
// Many questions about one light, over all cores.
#pragma once

#include <cstdint>
#include <span>

#include "penumbra/geometry/light_shape.h"
#include "penumbra/shadow/shadow_query.h"
#include "penumbra/visibility/committed.h"
#include "penumbra/visibility/occluders.h"

namespace penumbra {

/// Where answers go, one row a point: each of these that is not empty is filled. For classes alone
/// no sample is traced.
struct Answers {
  std::span<Visibility> visibility{};
  std::span<float> fraction{};
  std::span<ShadowClass> shadow_class{};
  std::span<std::uint32_t> free_samples{};  ///< ceil(d / 32) words a point
};

/// Answers of what was committed. Blocks of points are answered each by itself, and their size does
/// not depend on the number of threads, so that no answer does. Throws Error for arguments that
/// cannot be meant, before anything is written, and Cancelled.
ShadowCounters ask(const Committed& occluders, const Points& points, const LightShape& light,
                   const AskOptions& options, const Answers& answers);

/// Throws Error where they cannot be meant; the light becomes what the questions need.
LightShape checked_light(const Committed& occluders, LightShape light);

/// Throws Error for a number of samples that cannot be meant.
void require_samples(std::uint32_t shadow_samples);

/// Unit, and 0 for a point that floats; what is no number stays none, so that the class is in
/// doubt.
Vec3f receiver_normal(Vec3f normal);

}  // namespace penumbra
