// SPDX-License-Identifier: MIT
#include "penumbra/shadow/shadow_scene.h"

#include <limits>

namespace penumbra {
namespace {

/// Shadow rays start up to 32 ulp of (largest coordinate + extent) off their surface (see
/// surface_point.h).
Box with_offsets(const Box& box) {
  if (box.is_empty()) return box;
  const Vec3d size(box.size()), lo(box.lo), hi(box.hi);
  const double pad = 64.0 * std::numeric_limits<float>::epsilon() *
                     (std::max(max_abs(lo), max_abs(hi)) + max_abs(size));
  const Vec3d all{pad, pad, pad};
  return outward(lo - all, hi + all);
}

void add_light(const LightShape& light, ShadowScene& scene) {
  scene.lights.push_back(light);
  scene.hulls.emplace_back(light, scene.receivers);
  scene.forms.emplace_back(scene.hulls.back());
}

}  // namespace

ShadowScene prepare_shadows(const Kernel& kernel, const ShapeSet& shapes,
                            const KernelOptions& options, std::span<const LightShape> lights,
                            Method method) {
  ShadowScene scene;
  scene.kernel = &kernel;
  scene.method = method;
  scene.receivers = with_offsets(kernel.bounds());
  for (const LightShape& light : lights) add_light(light, scene);
  if (has_shadow_set(method))
    scene.set = build_shadow_set(kernel.records(), scene.hulls,
                                 method == Method::offset ? Offsets::full : Offsets::reduced,
                                 scene.receivers);
  if (method == Method::umbra)
    scene.inner = InnerVolumes(shapes, options.casts_no_shadow, scene.hulls);
  if (method == Method::shaft)
    scene.sheet = std::make_shared<const TriangleSheet>(shapes, kernel.records());
  return scene;
}

ShadowScene with_moved_shapes(const ShadowScene& prepared, const Kernel& kernel,
                              const ShapeSet& shapes) {
  ShadowScene scene;
  scene.kernel = &kernel;
  scene.method = Method::shaft;
  scene.receivers = with_offsets(kernel.bounds());
  scene.sheet = prepared.sheet->fits(kernel.records())
                    ? prepared.sheet
                    : std::make_shared<const TriangleSheet>(shapes, kernel.records());
  return scene;
}

ShadowScene with_light(const ShadowScene& prepared, const LightShape& light, Method method,
                       const Box& receivers) {
  ShadowScene scene;
  scene.kernel = prepared.kernel;
  scene.method = method;
  scene.receivers = prepared.receivers;
  if (!receivers.is_empty()) scene.receivers.add(with_offsets(receivers));
  scene.sheet = prepared.sheet;
  add_light(light, scene);
  return scene;
}

}  // namespace penumbra
