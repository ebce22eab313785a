// SPDX-License-Identifier: MIT
// A square of pixels: what one thread draws at a time.
#pragma once

#include <cstdint>

#include "penumbra/scene/image.h"
#include "penumbra/trace/pixel.h"
#include "penumbra/trace/ray_tree.h"
#include "penumbra/trace/z_order.h"

namespace penumbra {

/// Draws the pixels of an area of at most `block_edge` squared. Neighbouring samples are traced in
/// waves. The occluder cache starts empty; `visibility` is the thread's memory. Returns counters
/// and times.
TraceScratch render_block(const TraceContext& context, const RenderOptions& options,
                          const CameraRays& camera, Area block, VisibilityScratch& visibility,
                          Image& image);

}  // namespace penumbra
