// SPDX-License-Identifier: MIT
// Scene + shadows -> picture.
#pragma once

#include <cstdint>
#include <string>

#include "penumbra/kernel/kernel.h"
#include "penumbra/scene/scene.h"
#include "penumbra/shadow/visibility.h"
#include "penumbra/trace/picture.h"

namespace penumbra {

/// The scene must be complete (`complete_scene`), and `shadows` prepared for it: they say by which
/// method.
/// Same scene, seed and options give the same bits for any `threads` and `tile`. Throws nothing but
/// what `progress` throws; memory is allocated by tile and pixel, not by ray.
Picture render(const Scene& scene, const ShadowScene& shadows, const RenderOptions& options);

/// Everything about one pixel as text for people: each path of the ray tree, hit, normal, each
/// light's class, visible fraction and samples.
std::string explain_pixel(const Scene& scene, const ShadowScene& shadows,
                          const RenderOptions& options, std::uint32_t x, std::uint32_t y);

}  // namespace penumbra
