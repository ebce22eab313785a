// SPDX-License-Identifier: MIT
#include "penumbra/trace/ray_tree.h"

#include <chrono>

namespace penumbra {
namespace {

struct Branch {
  Vec3d origin, direction;
  std::uint64_t path;
  std::uint32_t depth;
};

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// One tree; a class because all its branches share these references.
class Tree {
 public:
  Tree(const TraceContext& context, std::uint64_t sample_key, TraceScratch& scratch,
       std::vector<RayNode>* nodes)
      : context_(context), sample_key_(sample_key), scratch_(scratch), nodes_(nodes) {}

  Color follow(const Branch& branch) {
    const Ray ray{Vec3f(branch.origin), Vec3f(branch.direction)};
    const Kernel::ClosestResult found = context_.shadows.kernel->closest(ray);
    scratch_.counters.closest_tests += found.tests;
    if (nodes_) nodes_->push_back({branch.path, found.hit, {}, {}, {}});
    const std::size_t node = nodes_ ? nodes_->size() - 1 : 0;
    if (!found.hit) return context_.scene.background.value_or(Color{});
    const ShadingPoint point = shading_point(context_.scene, found.hit->shape, branch.origin,
                                             branch.direction, found.hit->t);
    if (nodes_) (*nodes_)[node].point = point;
    Color color = point.material->emission + context_.scene.ambient * point.diffuse;
    color += direct_light(point, branch.path, node);
    if (branch.depth < context_.depth) color += secondary(point, branch);
    return color;
  }

 private:
  Color direct_light(const ShadingPoint& point, std::uint64_t path, std::size_t node) {
    const double start = seconds_now();
    const std::uint64_t key = hash(sample_key_, path);
    Color sum;
    for (std::uint32_t i = 0; i < context_.scene.lights.size(); ++i) {
      const Light& light = context_.scene.lights[i];
      const Visibility seen =
          visibility(context_.shadows, i, {point.receiver, point.normal}, light_key(key, i),
                     scratch_.cache.queue(path, i), scratch_.visibility, scratch_.counters.shadow);
      const Color u = seen.cosine_weighted > 0 || nodes_ ? unshadowed(light, point) : Color{};
      sum += u * seen.cosine_weighted;
      if (!nodes_) continue;
      (*nodes_)[node].light.push_back(seen);
      (*nodes_)[node].unshadowed.push_back(u);
    }
    scratch_.shadow_seconds += seconds_now() - start;
    return sum;
  }

  Color secondary(const ShadingPoint& point, const Branch& branch) {
    Color mirror = point.material->mirror, sum;
    const Color transmission = point.material->transmission;
    if (max_abs(transmission) > 0) {
      if (const auto through = refracted(point)) {
        ++scratch_.counters.refracted;
        sum += transmission * follow({Vec3d(behind_position(point.surface)), Vec3d(*through),
                                      2 * branch.path + 1, branch.depth + 1});
      } else {
        mirror += transmission;  // total reflection carries what would have gone through
      }
    }
    if (max_abs(mirror) > 0) {
      ++scratch_.counters.reflected;
      sum += mirror * follow({Vec3d(point.receiver), Vec3d(mirrored(point)), 2 * branch.path,
                              branch.depth + 1});
    }
    return sum;
  }

  const TraceContext& context_;
  std::uint64_t sample_key_;
  TraceScratch& scratch_;
  std::vector<RayNode>* nodes_;
};

}  // namespace

Color trace(const TraceContext& context, Vec3d origin, Vec3d direction, std::uint64_t sample_key,
            TraceScratch& scratch, std::vector<RayNode>* nodes) {
  ++scratch.counters.primary;
  return Tree(context, sample_key, scratch, nodes).follow({origin, direction, 1, 1});
}

}  // namespace penumbra
