// SPDX-License-Identifier: MIT
// What a skilled user of Embree would write: the competitor that benches measure against, and an
// independent witness in tests. Not used for pictures: its triangle test is another one than ours.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "penumbra/geometry/light_sampling.h"
#include "penumbra/geometry/shape.h"
#include "penumbra/kernel/kernel.h"

namespace penumbra {

enum class Coherence { none, coherent };

/// Native triangles and spheres; cones and rings as user geometry that calls our intersector.
/// High-quality build.
class EmbreeBaseline {
 public:
  /// Throws std::runtime_error when Embree cannot be had.
  explicit EmbreeBaseline(const ShapeSet& shapes);
  ~EmbreeBaseline();
  EmbreeBaseline(EmbreeBaseline&&) noexcept;
  EmbreeBaseline& operator=(EmbreeBaseline&&) noexcept;

  /// `rtcIntersect1`.
  std::optional<Hit> closest(const Ray& ray) const;

  /// `rtcOccluded8` in packets of 8 neighbouring samples; the words as in `Kernel::occluded`.
  void occluded8(const LightSamples& rays, std::span<const std::uint32_t> active,
                 std::span<std::uint32_t> blocked, Coherence coherence) const;

  /// `rtcOccluded16` in packets of 16.
  void occluded16(const LightSamples& rays, std::span<const std::uint32_t> active,
                  std::span<std::uint32_t> blocked, Coherence coherence) const;

  /// `rtcOccluded1M` over all active rays at once.
  void occluded_stream(const LightSamples& rays, std::span<const std::uint32_t> active,
                       std::span<std::uint32_t> blocked, Coherence coherence) const;

  /// What Embree has allocated for it, by its memory monitor.
  std::size_t memory_bytes() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace penumbra
