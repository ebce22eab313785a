// SPDX-License-Identifier: MIT
// A picture, what it cost, and how one is wished for. Names nothing of what draws it.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "penumbra/scene/image.h"
#include "penumbra/shadow/shadow_query.h"

namespace penumbra {

/// Image layers beside the colour.
enum class Aov { light_class, visibility, depth, normal, samples };

/// Questions that were asked together, and their answers: those of one wave of a block (all rays at
/// the same node of their trees) about one light.
struct AnsweredBatch {
  std::uint32_t block;  ///< of `block_edge` squared pixels, numbered row by row
  std::uint64_t path;   ///< of the ray tree, see RayNode
  std::uint32_t light;
  std::span<const ShadowQuery> queries;
  std::span<const Visibility> seen;
};

/// A sample of a pixel, (0, 0) in the upper left corner.
struct PixelSample {
  std::uint32_t x = 0, y = 0, sample = 0;
};

/// What the questions behind a pixel's sample are drawn by: the key of its point at this path of
/// the ray tree, of which `light_key` makes `ShadowQuery::key`. `seed` as in RenderOptions.
std::uint64_t point_key(std::uint64_t seed, const PixelSample& sample, std::uint64_t path);

/// Where the one ray of a pixel goes: through its centre, or, as the Standard Procedural Databases
/// have it, through its upper left corner. More samples a pixel are spread over it.
enum class PixelPoint { center, corner };

/// How a scene is drawn.
struct RenderOptions {
  std::uint32_t shadow_samples = 32;  ///< d, >= 1
  std::uint32_t width = 512, height = 512;
  std::uint32_t samples_per_pixel = 1;
  PixelPoint pixel_point = PixelPoint::center;
  std::uint32_t depth = 5;  ///< longest path of the ray tree, the camera ray being 1
  std::uint64_t seed = 0;
  /// Edge of the square tiles threads take, in pixels, rounded up to whole blocks of `block_edge`;
  /// changes no result.
  std::uint32_t tile = 16;
  std::uint32_t threads = 0;  ///< 0: all
  std::vector<Aov> aovs{};
  /// Called with the finished share in [0, 1], from any thread, one call at a time. What it throws
  /// ends the picture, and comes out of `render`.
  std::function<void(double)> progress{};
  /// Called with every batch that is not empty, from any thread, several calls at a time. Those of
  /// one block come in order, from one thread.
  std::function<void(const AnsweredBatch&)> observe{};
};

/// The occluder cache lives in one block of this edge, so that counters depend on no tile or
/// thread.
inline constexpr std::uint32_t block_edge = 16;

/// Exact integers, equal for any number of threads and any tile size.
struct RenderCounters {
  std::uint64_t primary = 0, reflected = 0, refracted = 0;  ///< rays for closest hits
  std::uint64_t closest_tests = 0;                          ///< primitives tested by them
  ShadowCounters shadow;

  void add(const RenderCounters& other);  ///< each to its like
};

/// What it took.
struct RenderSeconds {
  double render = 0;  ///< wall time of the picture
  double shadow = 0;  ///< of it, in visibility; summed over threads, divided by their number
};

/// A drawn scene.
struct Picture {
  Image image;  ///< linear R, G, B, then the layers asked for
  RenderCounters counters;
  RenderSeconds seconds;
  std::uint32_t threads = 1;
};

}  // namespace penumbra
