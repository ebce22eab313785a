// SPDX-License-Identifier: MIT
// Which primitives does a ray, or a packet of rays, meet? One interface, one intersector, two
// kernels: the eight-wide hierarchy, and brute force, the judge.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "penumbra/geometry/light_sampling.h"
#include "penumbra/geometry/shape.h"
#include "penumbra/kernel/record_table.h"
#include "penumbra/kernel/traverse.h"

namespace penumbra {

/// Points origin + t direction, t_min < t < t_max, t_min >= 0. The direction need not be unit
/// length, but 1e-18 to 1e18: others may miss what they should hit (the same in every kernel).
struct Ray {
  Vec3f origin, direction;
  float t_min = 0, t_max = std::numeric_limits<float>::infinity();
};

/// The nearest primitive a ray meets.
struct Hit {
  float t = 0;
  ShapeRef shape;
};

enum class KernelKind { wide, brute };

struct KernelOptions {
  KernelKind kind = KernelKind::wide;
  /// By surface: true where it does not block light. Shorter than the surfaces: the rest blocks.
  std::vector<bool> casts_no_shadow;
};

class Kernel {
 public:
  /// Shapes are copied in the form that is traversed, groups once. They must be valid (see
  /// `validate`): finite, in range. Cost: O(n log n) over all cores. Deterministic.
  Kernel(const ShapeSet& shapes, const KernelOptions& options);
  ~Kernel();

  /// The kernel of the same shapes elsewhere: `shapes` must have as many of everything, in the same
  /// order, groups and instances too. Records are made anew and boxes fitted to them; the tree
  /// keeps its shape, so that questions become slower the farther shapes have moved. Answers are
  /// those of a new kernel, but where several hits tie. Cost: linear; memory of a second kernel.
  Kernel refitted(const ShapeSet& shapes) const;

  Kernel(Kernel&&) noexcept;
  Kernel& operator=(Kernel&&) noexcept;

  /// The nearest hit; nothing when there is none. Ties: the set's own before what instances place,
  /// instances in their order, then the smaller ShapeRef in the order of `all_primitives`.
  struct ClosestResult {
    std::optional<Hit> hit;
    std::uint32_t tests = 0;
  };
  ClosestResult closest(const Ray& ray) const;

  /// The record of the nearest hit, as an index into `records`; `no_record` where there is none.
  std::uint32_t closest_record(const Ray& ray) const;

  /// Which of the rays of one receiver are blocked. Bit i of `active` says that ray i is wanted;
  /// bit i of `blocked` is set if and only if it is wanted and at least one shadow-casting
  /// primitive meets its open segment. Both hold ceil(count / 32) words. Equal, bit for bit, for
  /// every KernelKind and instruction set.
  OccludedReport occluded(const LightSamples& rays, std::span<const std::uint32_t> active,
                          std::span<std::uint32_t> blocked) const;

  /// The same, one ray after the other: see `occluded_singly` in traverse.h. Brute force knows no
  /// recent records.
  SingleReport occluded_singly(const LightSamples& rays, std::span<const std::uint32_t> active,
                               RecentRecords& recent, std::span<std::uint32_t> blocked) const;

  /// The shapes in the form that is traversed, in an order of the kernel's own: those of the set,
  /// then those of each instance.
  RecordTable records() const;

  /// Which primitive one of them is.
  ShapeRef shape(std::uint32_t record) const;

  /// The hierarchy over them, for `walk`; brute force has no nodes.
  const WideTree& tree() const;

  std::size_t memory_bytes() const;
  Box bounds() const;

 private:
  struct Data;
  explicit Kernel(std::unique_ptr<const Data> data);
  std::unique_ptr<const Data> data_;
};

}  // namespace penumbra
