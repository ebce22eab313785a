// SPDX-License-Identifier: MIT
#include "penumbra/trace/prepare.h"

namespace penumbra {

KernelOptions kernel_options(const Scene& scene) {
  KernelOptions options;
  for (const Material& material : scene.materials)
    options.casts_no_shadow.push_back(!material.casts_shadow);
  return options;
}

ShadowScene prepare_shadows(const Scene& scene, const Kernel& kernel, Method method) {
  std::vector<LightShape> lights;
  for (const Light& light : scene.lights) lights.push_back(light.shape);
  return prepare_shadows(kernel, scene.shapes, kernel_options(scene), lights, method);
}

}  // namespace penumbra
