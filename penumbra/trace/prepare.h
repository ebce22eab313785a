// SPDX-License-Identifier: MIT
// From a scene to what answers its questions of visibility.
#pragma once

#include "penumbra/kernel/kernel.h"
#include "penumbra/scene/scene.h"
#include "penumbra/shadow/shadow_scene.h"

namespace penumbra {

/// Which of the scene's surfaces block no light.
KernelOptions kernel_options(const Scene& scene);

/// What the method needs. `kernel` is built from the scene's shapes with its `kernel_options`, and
/// must outlive the result.
ShadowScene prepare_shadows(const Scene& scene, const Kernel& kernel, Method method);

}  // namespace penumbra
