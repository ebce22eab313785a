// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "penumbra/trace/names.h"
#include "penumbra/trace/pixel.h"
#include "penumbra/trace/ray_tree.h"
#include "penumbra/trace/render.h"

namespace penumbra {
namespace {

template <typename N>
std::string text(Vec3<N> v) {
  return fmt::format("({:.9g}, {:.9g}, {:.9g})", v.x, v.y, v.z);
}

std::string describe(const RayNode& node) {
  std::string out = fmt::format("  {}: ", path_name(node.path));
  if (!node.hit) return out + "hits nothing\n";
  const ShapeRef shape = node.hit->shape;
  out += shape.kind == ShapeKind::triangle
             ? fmt::format("mesh {} triangle {}", shape.index, shape.triangle)
             : fmt::format("{} {}", name_of(shape.kind), shape.index);
  if (shape.instance > 0) out += fmt::format(" of instance {}", shape.instance - 1);
  out += fmt::format(", t = {:.9g}{}\n", node.hit->t,
                     node.point.surface.is_back ? ", from inside" : "");
  out += fmt::format("    material \"{}\", diffuse {}\n", node.point.material->name,
                     text(node.point.diffuse));
  out += fmt::format("    position {}, shadow rays from {}\n", text(node.point.surface.position),
                     text(node.point.receiver));
  out += fmt::format("    normal {}, shading normal {}\n", text(node.point.normal),
                     text(node.point.shading_normal));
  for (std::size_t i = 0; i < node.light.size(); ++i)
    out += fmt::format("    light {}: {}, V = {:.9g}, fraction = {:.9g}, U = {}\n", i,
                       name_of(node.light[i].shadow_class), node.light[i].cosine_weighted,
                       node.light[i].fraction, text(node.unshadowed[i]));
  return out;
}

}  // namespace

std::string explain_pixel(const Scene& scene, const ShadowScene& shadows,
                          const RenderOptions& options, std::uint32_t x, std::uint32_t y) {
  VisibilityScratch visibility(options.shadow_samples);
  TraceScratch scratch(visibility, scene.lights.size());
  std::vector<CameraRay> rays;
  CameraRays(*scene.camera, options).of_pixel(x, y, rays);
  std::string out = fmt::format("pixel {},{}\n", x, y);
  Vec3d sum;
  for (std::size_t s = 0; s < rays.size(); ++s) {
    std::vector<RayNode> nodes;
    const TraceContext context{scene, shadows, options.depth};
    const WaveRay ray{rays[s].origin, rays[s].direction, rays[s].key, 0};
    const Color color = trace(context, {&ray, 1}, scratch, &nodes).front().color;
    sum += Vec3d(color);
    out += fmt::format(" sample {}: colour {}\n", s, text(color));
    for (const RayNode& node : nodes) out += describe(node);
  }
  const ShadowCounters& shadow = scratch.counters.shadow;
  out +=
      fmt::format(" colour {}\n {} shadow rays, {} tests; queries: {} lit, {} penumbra, {} umbra\n",
                  text(sum / static_cast<double>(rays.size())), shadow.rays, shadow.tests,
                  shadow.lit, shadow.penumbra, shadow.umbra);
  return out;
}

}  // namespace penumbra
