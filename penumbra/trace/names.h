// SPDX-License-Identifier: MIT
// Things by name, in texts for people.
#pragma once

#include <cstdint>
#include <string>

#include "penumbra/geometry/shape.h"
#include "penumbra/shadow/visibility.h"

namespace penumbra {

const char* name_of(ShapeKind kind);
const char* name_of(ShadowClass shadow_class);

/// Of the ray tree: "camera ray", "camera ray > reflected > refracted".
std::string path_name(std::uint64_t path);

}  // namespace penumbra
