// SPDX-License-Identifier: MIT
// Which points does a closed surface enclose? Crossings of straight lines are counted, modulo 2, so
// that neither orientation nor self-intersection matters.
//
// A line along z crosses a triangle where an odd number of the three edges, seen along z, pass it
// on one side. Whether an edge does is computed the same for every triangle that has it, so that
// each line crosses a closed surface an even number of times: rounding moves the surface by 1e-15
// of its coordinates but opens no gap.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "penumbra/geometry/flat_triangle.h"

namespace penumbra {

/// Whether a closed surface encloses p: a path from p to infinity crosses it an odd number of
/// times. Sure where p is more than 1e-12 of the largest coordinate off the surface. Cost: linear.
bool is_inside(std::span<const FlatTriangle> surface, Vec3d p);

/// Points that a closed surface encloses: along lines x lines x 3 axis-parallel lines through its
/// box, the middle of each stretch inside; along those of z also points evenly spaced. As sure as
/// `is_inside`. Cost: linear in the triangles and in the crossings.
std::vector<Vec3d> inside_points(std::span<const FlatTriangle> surface, std::size_t lines);

}  // namespace penumbra
