// SPDX-License-Identifier: MIT
// A square of pixels: what one thread draws at a time.
#pragma once

#include <cstdint>

#include "penumbra/scene/image.h"
#include "penumbra/trace/pixel.h"
#include "penumbra/trace/ray_tree.h"

namespace penumbra {

/// Pixels of a part of the picture.
struct Area {
  std::uint32_t x_begin, x_end, y_begin, y_end;
  std::uint64_t pixels() const { return std::uint64_t(x_end - x_begin) * (y_end - y_begin); }
};

/// Draws the pixels of an area of at most `block_edge` squared. Neighbouring samples are traced in
/// waves. The occluder cache starts empty; `visibility` is the thread's memory. Returns counters
/// and times.
TraceScratch render_block(const TraceContext& context, const RenderOptions& options,
                          const CameraRays& camera, Area block, VisibilityScratch& visibility,
                          Image& image);

}  // namespace penumbra
