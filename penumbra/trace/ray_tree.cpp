// SPDX-License-Identifier: MIT
#include "penumbra/trace/ray_tree.h"

#include "penumbra/trace/clock.h"

namespace penumbra {
namespace {

/// Rays at one node of their trees, and what each adds to its parent.
struct Wave {
  std::vector<WaveRay> rays;
  std::vector<Color> factor;  ///< of the colour along the ray
  std::uint64_t path = 1;
  std::uint32_t depth = 1;
  bool is_empty() const { return rays.empty(); }
  void add(const WaveRay& ray, Color by) { rays.push_back(ray), factor.push_back(by); }
};

/// The trees of one call; a class because all waves share these references.
class Trees {
 public:
  Trees(const TraceContext& context, TraceScratch& scratch, std::vector<RayNode>* nodes,
        std::size_t count)
      : results(count), context_(context), scratch_(scratch), nodes_(nodes) {}

  void follow(const Wave& wave) {
    std::vector<ShadingPoint> points;
    std::vector<std::uint32_t> hits;  // rays of the wave, one a point
    const std::size_t first_node = nodes_ ? nodes_->size() : 0;
    for (std::uint32_t i = 0; i < wave.rays.size(); ++i) {
      const WaveRay& ray = wave.rays[i];
      const Kernel::ClosestResult found =
          context_.shadows.kernel->closest({Vec3f(ray.origin), Vec3f(ray.direction)});
      scratch_.counters.closest_tests += found.tests;
      if (nodes_) nodes_->push_back({wave.path, found.hit, {}, {}, {}});
      if (!found.hit) {
        add(wave, i, context_.scene.background.value_or(Color{}));
        continue;
      }
      points.push_back(
          shading_point(context_.scene, found.hit->shape, ray.origin, ray.direction, found.hit->t));
      hits.push_back(i);
      if (nodes_) nodes_->back().point = points.back();
    }
    shade(wave, hits, points, first_node);
    if (wave.depth == context_.depth) return;
    const auto [reflected, refracted] = secondary(wave, hits, points);
    scratch_.counters.reflected += reflected.rays.size();
    scratch_.counters.refracted += refracted.rays.size();
    if (!refracted.is_empty()) follow(refracted);
    if (!reflected.is_empty()) follow(reflected);
  }

  std::vector<TreeResult> results;

 private:
  void add(const Wave& wave, std::uint32_t ray, Color color) {
    results[wave.rays[ray].tree].color += wave.factor[ray] * color;
  }

  /// Light of its own and from the lamps, reflected at each point.
  void shade(const Wave& wave, const std::vector<std::uint32_t>& hits,
             const std::vector<ShadingPoint>& points, std::size_t first_node) {
    const double start = now_seconds();
    std::vector<Color> sums;
    for (const ShadingPoint& point : points)
      sums.push_back(emitted(point) + context_.scene.ambient * point.diffuse);
    Questions q;
    std::vector<Visibility> seen;
    for (std::uint32_t light = 0; light < context_.scene.lights.size(); ++light) {
      ask(wave, hits, points, light, q);
      seen.assign(points.size(), {});
      for (std::size_t i = 0; i < q.point.size(); ++i) seen[q.point[i]] = q.answers[i];
      for (std::size_t k = 0; k < points.size(); ++k) {
        const bool matters = seen[k].cosine_weighted > 0 || nodes_;
        const Color u = matters ? unshadowed(context_.scene.lights[light], points[k]) : Color{};
        sums[k] += u * seen[k].cosine_weighted;
        results[wave.rays[hits[k]].tree].shadow_rays += seen[k].rays;
        if (!nodes_) continue;
        (*nodes_)[first_node + hits[k]].light.push_back(seen[k]);
        (*nodes_)[first_node + hits[k]].unshadowed.push_back(u);
      }
    }
    for (std::size_t k = 0; k < points.size(); ++k) add(wave, hits[k], sums[k]);
    scratch_.shadow_seconds += now_seconds() - start;
  }

  /// What is asked about one light, of which points, and the answers.
  struct Questions {
    std::vector<std::size_t> point;
    std::vector<ShadowQuery> queries;
    std::vector<Visibility> answers;
  };

  /// How much of a light the points see. No question is asked, whatever the method, where the
  /// light's beam sends nothing.
  void ask(const Wave& wave, const std::vector<std::uint32_t>& hits,
           const std::vector<ShadingPoint>& points, std::uint32_t light, Questions& q) {
    q.point.clear(), q.queries.clear();
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (!(beam_factor(context_.scene.lights[light], points[k].receiver) > 0)) continue;
      q.point.push_back(k);
      q.queries.push_back({{points[k].receiver, points[k].normal},
                           light_key(hash(wave.rays[hits[k]].sample_key, wave.path), light)});
    }
    q.answers.resize(q.queries.size());
    visibilities(context_.shadows, light, q.queries, scratch_.cache.queue(wave.path, light),
                 scratch_.visibility, scratch_.counters.shadow, q.answers);
    if (scratch_.observe && !q.queries.empty())
      (*scratch_.observe)({scratch_.block, wave.path, light, q.queries, q.answers});
  }

  /// The next two waves. Total reflection carries what would have gone through.
  static std::pair<Wave, Wave> secondary(const Wave& wave, const std::vector<std::uint32_t>& hits,
                                         const std::vector<ShadingPoint>& points) {
    Wave reflected, refracted;
    reflected.path = 2 * wave.path, refracted.path = 2 * wave.path + 1;
    reflected.depth = refracted.depth = wave.depth + 1;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const ShadingPoint& point = points[k];
      const WaveRay& ray = wave.rays[hits[k]];
      const Color factor = wave.factor[hits[k]], transmission = point.material->transmission;
      Color mirror = point.material->mirror;
      if (max_abs(transmission) > 0) {
        if (const auto through = refracted_direction(point))
          refracted.add(
              {Vec3d(behind_position(point.surface)), Vec3d(*through), ray.sample_key, ray.tree},
              factor * transmission);
        else
          mirror += transmission;
      }
      if (max_abs(mirror) > 0)
        reflected.add(
            {Vec3d(point.receiver), Vec3d(mirrored_direction(point)), ray.sample_key, ray.tree},
            factor * mirror);
    }
    return {std::move(reflected), std::move(refracted)};
  }

  const TraceContext& context_;
  TraceScratch& scratch_;
  std::vector<RayNode>* nodes_;
};

}  // namespace

std::vector<TreeResult> trace(const TraceContext& context, std::span<const WaveRay> camera_rays,
                              TraceScratch& scratch, std::vector<RayNode>* nodes) {
  scratch.counters.primary += camera_rays.size();
  Trees trees(context, scratch, nodes, camera_rays.size());
  Wave wave;
  for (const WaveRay& ray : camera_rays) wave.add(ray, {1, 1, 1});
  trees.follow(wave);
  return std::move(trees.results);
}

}  // namespace penumbra
