// SPDX-License-Identifier: MIT
// The questions a kernel answers, over records: by hierarchy, and by brute force.
#pragma once

#include <cstdint>
#include <span>

#include "penumbra/geometry/light_sampling.h"
#include "penumbra/kernel/wide_tree.h"

namespace penumbra {

struct Ray;

/// Nearest record: `found` says whether there is one.
struct NearestRecord {
  float t = 0;
  std::uint32_t id = 0;
  std::uint32_t tests = 0;
  bool found = false;
};

// Through the tree, on the best instruction set that this processor has.
NearestRecord nearest(const WideTree& tree, const Ray& ray);
std::uint64_t occluded(const WideTree& tree, const LightSamples& rays,
                       std::span<const std::uint32_t> active, std::span<std::uint32_t> blocked);

// One ray and one record at a time, on the compiler's baseline instruction set: the judge.
NearestRecord nearest_brute(std::span<const Record> records, const Ray& ray);
std::uint64_t occluded_brute(std::span<const Record> records, const LightSamples& rays,
                             std::span<const std::uint32_t> active,
                             std::span<std::uint32_t> blocked);

/// The instruction set that `nearest` and `occluded` run on, such as "AVX2".
const char* instruction_set();

}  // namespace penumbra
