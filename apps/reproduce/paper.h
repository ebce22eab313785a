// SPDX-License-Identifier: MIT
// What A. Formella and A. Lukaszewski, Fast Penumbra Calculation in Ray Tracing (WSCG 1998), print
// of their measurements: 128 x 128 pixels, d = 32, lights that are balls, a Sun at 168 MHz. Only
// figures that we have from the paper stand here; where one is missing, its place stays empty.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace penumbra::reproduce {

/// Of one scene in Tables 1 and 2.
struct PaperScene {
  const char* title;
  std::uint64_t objects;
  double seconds_plain, seconds_best;  ///< row (b); the fastest of (c) to (e)
  std::uint64_t shadow_rays_plain, shadow_rays_best;
  std::optional<std::uint64_t> shadow_rays_hard;  ///< row (a)
  std::optional<std::uint64_t> reflected;
  std::optional<double> slope_ratio;  ///< Figures 6 to 8: classical over fast
};

/// Cylinders, Balls4, Rings, Molecule, Bust: the order of the tables.
extern const std::array<PaperScene, 5> paper_scenes;

/// Table 4, Balls3: light radii, those of the scene's spheres, and speed-ups, where we have them.
struct PaperLight {
  const char* radius;  ///< as a fraction
  double value;
  std::optional<double> speedup;
};
extern const std::array<PaperLight, 4> paper_lights;

inline constexpr std::uint64_t paper_primary_rays = 16384;
inline constexpr double paper_most_memory = 2;  ///< times that of the geometry set alone

}  // namespace penumbra::reproduce
