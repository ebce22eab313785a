// SPDX-License-Identifier: MIT
// The shadow classes of a picture's points as colours.
#pragma once

#include "penumbra/scene/image.h"

namespace penumbra::reproduce {

/// R, G and B (linear) of the channels `class.light0`, `class.light1`, ...: lit is pale yellow,
/// penumbra vermilion, umbra dark blue; of several lights the mean of their sRGB codes, since
/// the mean of linear values would hide the dark ones. Throws Error where there is no
/// such channel.
Image class_map(const Image& picture);

}  // namespace penumbra::reproduce
