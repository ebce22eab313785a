// SPDX-License-Identifier: MIT
// What a skilled user of Embree would write: the competitor that benches measure against, and an
// independent witness in tests. Not used for pictures: its triangle test is another one than ours.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "penumbra/geometry/light_sampling.h"
#include "penumbra/geometry/shape.h"
#include "penumbra/kernel/kernel.h"

namespace penumbra {

enum class Coherence { none, coherent };
enum class EmbreeCall { packets_of_8, packets_of_16, stream };

/// Embree's own spheres test one ray against several spheres, user geometry a packet against one:
/// the latter is faster for the rays of a point (1.2 to 1.9 times, d = 32, AVX-512).
enum class EmbreeSpheres { native, user };

/// A way to ask Embree.
struct EmbreeVariant {
  EmbreeCall call = EmbreeCall::packets_of_8;
  Coherence coherence = Coherence::coherent;
};

/// "rtcOccluded8, coherent"
std::string name_of(EmbreeVariant variant);

/// "3.13.5"
std::string embree_version();

/// Rays of any origins: ray i is origin[i] + t direction[i] for 0 < t < t_max. Neighbours share
/// packets.
struct MixedRays {
  std::vector<float> origin[3], direction[3];  ///< padded as LightSamples
  float t_max = 1;
  std::uint32_t count = 0;

  void resize(std::uint32_t rays);
  void set(std::uint32_t i, Vec3f from, Vec3f along);
};

/// Native triangles and spheres; cones and rings as user geometry, tested in SIMD lanes.
/// High-quality build.
class EmbreeBaseline {
 public:
  /// Throws std::runtime_error when Embree cannot be had.
  explicit EmbreeBaseline(const ShapeSet& shapes, EmbreeSpheres spheres = EmbreeSpheres::native);
  ~EmbreeBaseline();
  EmbreeBaseline(EmbreeBaseline&&) noexcept;
  EmbreeBaseline& operator=(EmbreeBaseline&&) noexcept;

  /// `rtcIntersect1`.
  std::optional<Hit> closest(const Ray& ray) const;

  /// The ways that make sense on this machine: packets of 16 where it has registers for them.
  std::vector<EmbreeVariant> variants() const;

  /// Which of the rays are blocked; the words as in `Kernel::occluded`. Packets hold neighbouring
  /// rays, a stream all that are active.
  void occluded(EmbreeVariant variant, const LightSamples& rays,
                std::span<const std::uint32_t> active, std::span<std::uint32_t> blocked) const;
  void occluded(EmbreeVariant variant, const MixedRays& rays, std::span<const std::uint32_t> active,
                std::span<std::uint32_t> blocked) const;

  /// What Embree has allocated for it, by its memory monitor, and the shapes of user geometry.
  std::size_t memory_bytes() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace penumbra
