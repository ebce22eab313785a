// SPDX-License-Identifier: MIT
// The shadow classes of a picture's points as colours.
#pragma once

#include "penumbra/scene/image.h"

namespace penumbra::reproduce {

/// R, G and B (linear) of the channel `class.light0`: lit is pale yellow, penumbra vermilion, umbra
/// dark blue; grey where the channel `depth.Z`, if there is one, says that nothing was hit. Throws
/// Error where there are no classes.
Image class_map(const Image& picture);

}  // namespace penumbra::reproduce
