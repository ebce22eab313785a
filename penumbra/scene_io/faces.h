// SPDX-License-Identifier: MIT
// Faces of any number of corners, from files that may claim anything.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "penumbra/geometry/mesh.h"
#include "penumbra/scene/error.h"

namespace penumbra {

/// Throws Error where a mesh has more vertices than 32 bits can name.
void check_vertex_count(const Error::Place& place, std::size_t vertices);

/// Adds a face of 3 or more corners, all of them indices below mesh.positions.size(). A triangle is
/// added as it is, even a degenerate one.
void append_face(Mesh& mesh, std::span<const std::uint32_t> corners);

}  // namespace penumbra
