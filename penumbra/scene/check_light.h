// SPDX-License-Identifier: MIT
// What a light's shape must be for the methods to be right about it.
#pragma once

#include <optional>

#include "penumbra/scene/light.h"

namespace penumbra {

struct LightProblem {
  const char* what;  ///< goes on from "light 3", as in "is not planar"
  const char* hint;
};

/// The first thing wrong with a light, or nothing. Directions need not be unit, but not 0. Flat
/// shapes may be bent, and convex ones dented, by what float coordinates cannot express, polygons
/// by a thousandth of their size. Cost: triangles times corners.
std::optional<LightProblem> problem_of(const LightShape& light);

/// Whether a light is so large that float loses, beside it, shapes of this extent: flat, long and
/// many-cornered ones are sampled in coordinates of their own size.
bool is_too_large(const LightShape& light, double extent);

/// What is wrong with the beam of a light of this shape. Its axis need not be unit, but not 0.
std::optional<LightProblem> problem_of(const Beam& beam, const LightShape& light);

}  // namespace penumbra
