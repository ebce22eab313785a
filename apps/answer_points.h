// SPDX-License-Identifier: MIT
// What points see of a scene's lights, block by block of a stream.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "penumbra/scene/scene.h"
#include "penumbra/scene_io/read_points.h"
#include "penumbra/shadow/method.h"
#include "penumbra/shadow/shadow_query.h"

namespace penumbra {

struct AnswerOptions {
  std::uint32_t shadow_samples = 32;
  Method method = Method::shaft;
  std::uint64_t seed = 0;
  std::uint32_t threads = 0;      ///< 0: all
  std::optional<float> offset{};  ///< along normals, in scene units; none: what float requires
  bool has_fractions = true;      ///< false: classes alone, for which no samples are taken
};

/// Of a block, row by row: a value for each light.
struct PointAnswers {
  std::vector<std::uint8_t> classes;
  std::vector<float> fractions;  ///< empty where they are not asked for
};

class PointAnswerer {
 public:
  /// Cost: O(n log n) over all cores. Throws Error.
  PointAnswerer(const Scene& scene, const AnswerOptions& options);
  ~PointAnswerer();

  /// `first` is the number in the stream of the block's first point: fractions depend on it, and
  /// not on where blocks begin and end, on method or threads. Classes are what was proven on the
  /// way, of neighbouring points together: blocks, method and number of samples may change them,
  /// threads do not. `progress` is called with the finished share in [0, 1], from any thread, one
  /// call at a time.
  ShadowCounters answer(const PointBlock& points, std::uint64_t first, PointAnswers& answers,
                        const std::function<void(double)>& progress);

  /// Of what is prepared of the scene.
  std::size_t memory_bytes() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace penumbra
