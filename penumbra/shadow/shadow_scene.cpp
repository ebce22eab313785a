// SPDX-License-Identifier: MIT
#include "penumbra/shadow/shadow_scene.h"

#include <limits>

namespace penumbra {
namespace {

/// Shadow rays start up to 32 ulp of (largest coordinate + extent) off their surface (see
/// surface_point.h).
Box with_offsets(const Box& box) {
  const Vec3d size(box.size()), lo(box.lo), hi(box.hi);
  const double pad = 64.0 * std::numeric_limits<float>::epsilon() *
                     (std::max(max_abs(lo), max_abs(hi)) + max_abs(size));
  const Vec3d all{pad, pad, pad};
  return outward(lo - all, hi + all);
}

}  // namespace

ShadowScene prepare_shadows(const Kernel& kernel, const ShapeSet& shapes,
                            const KernelOptions& options, std::span<const LightShape> lights,
                            Method method) {
  ShadowScene scene;
  scene.kernel = &kernel;
  scene.method = method;
  scene.lights.assign(lights.begin(), lights.end());
  scene.receivers = with_offsets(kernel.bounds());
  for (const LightShape& light : lights) {
    scene.hulls.emplace_back(light, scene.receivers);
    scene.forms.emplace_back(scene.hulls.back());
  }
  if (has_shadow_set(method))
    scene.set = build_shadow_set(kernel.records(), scene.hulls,
                                 method == Method::offset ? Offsets::full : Offsets::reduced,
                                 scene.receivers);
  if (method == Method::umbra)
    scene.inner = InnerVolumes(shapes, options.casts_no_shadow, scene.hulls);
  if (method == Method::shaft) scene.sheet = TriangleSheet(shapes, kernel.records());
  return scene;
}

}  // namespace penumbra
