// SPDX-License-Identifier: MIT
#include "penumbra/shadow/embree_visibility.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "penumbra/shadow/samples.h"

namespace penumbra {

// So many points fill packets of any width, whatever d is.
constexpr std::size_t points_together = 16;

EmbreeScratch::EmbreeScratch(std::uint32_t shadow_samples)
    : points(points_together, SampleScratch(shadow_samples)) {}

namespace {

/// Samples that fill the calls of this variant.
std::uint32_t full_call(EmbreeVariant variant) {
  switch (variant.call) {
    case EmbreeCall::packets_of_8: return 8;
    case EmbreeCall::packets_of_16: return 16;
    case EmbreeCall::stream: break;
  }
  return 32;  // what Embree takes from a stream at a time
}

void count(const Visibility& seen, ShadowCounters& counters) {
  counters.rays += seen.rays;
  counters.count(seen.shadow_class);
}

/// The answer of a point whose `blocked` is known.
Visibility conclude(const SampleScratch& point, std::uint32_t rays, ShadowCounters& counters) {
  if (rays == 0) return {0, 0, ShadowClass::umbra};
  Visibility seen = sum_up(point);
  seen.shadow_class = class_by_samples(point, seen);
  seen.rays = rays;
  count(seen, counters);
  return seen;
}

/// Everything that the answers to some questions about one light share.
class EmbreeAnswers {
 public:
  EmbreeAnswers(const EmbreeBaseline& embree, EmbreeVariant variant, const ShadowScene& scene,
                std::uint32_t light, EmbreeScratch& scratch, ShadowCounters& counters)
      : embree_(embree),
        variant_(variant),
        scene_(scene),
        light_(light),
        scratch_(scratch),
        counters_(counters) {}

  /// Packets of one point's rays.
  Visibility alone(const ShadowQuery& query) {
    SampleScratch& point = scratch_.points[0];
    const std::uint32_t rays = take_samples(scene_, light_, query.receiver, query.key, point);
    if (rays > 0) embree_.occluded(variant_, point.samples, point.active, point.blocked);
    return conclude(point, rays, counters_);
  }

  /// Packets that hold rays of several points.
  void together(std::span<const ShadowQuery> queries, std::span<Visibility> seen) {
    std::uint32_t rays[points_together] = {}, first = 0;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      SampleScratch& point = scratch_.points[i];
      rays[i] = take_samples(scene_, light_, queries[i].receiver, queries[i].key, point);
      const std::uint32_t d = point.samples.count;
      if (i == 0) begin_rays(static_cast<std::uint32_t>(queries.size()) * d, point.samples.t_max);
      for (std::uint32_t k = 0; k < d; ++k)
        set_ray(first + k, point.samples.origin,
                {point.samples.x[k], point.samples.y[k], point.samples.z[k]},
                point.active[k / 32] >> k % 32 & 1);
      first += d;
    }
    embree_.occluded(variant_, scratch_.rays, scratch_.active, scratch_.blocked);
    first = 0;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      SampleScratch& point = scratch_.points[i];
      std::fill(point.blocked.begin(), point.blocked.end(), 0u);
      for (std::uint32_t k = 0; k < point.samples.count; ++k, ++first)
        point.blocked[k / 32] |= (scratch_.blocked[first / 32] >> first % 32 & 1) << k % 32;
      seen[i] = conclude(point, rays[i], counters_);
    }
  }

  /// One ray a point, to the light's centre.
  void hard(std::span<const ShadowQuery> queries, std::span<Visibility> seen) {
    const LightShape& shape = scene_.lights[light_];
    const std::optional<Vec3f> middle = center(shape);
    const Vec3f towards_sun = middle ? Vec3f{} : towards_center(shape, {});
    begin_rays(static_cast<std::uint32_t>(queries.size()),
               middle ? 1 : std::numeric_limits<float>::infinity());
    for (std::uint32_t i = 0; i < queries.size(); ++i) {
      const auto& [position, normal] = queries[i].receiver;
      const Vec3f to = middle ? *middle - position : towards_sun;
      set_ray(i, position, to, dot(to, normal) > 0);
    }
    embree_.occluded(variant_, scratch_.rays, scratch_.active, scratch_.blocked);
    for (std::uint32_t i = 0; i < queries.size(); ++i) {
      const bool is_traced = scratch_.active[i / 32] >> i % 32 & 1;
      const bool is_free = is_traced && !(scratch_.blocked[i / 32] >> i % 32 & 1);
      seen[i] = is_free ? Visibility{1, 1, ShadowClass::lit, 1}
                        : Visibility{0, 0, ShadowClass::umbra, is_traced};
      if (is_traced) count(seen[i], counters_);
    }
  }

 private:
  void begin_rays(std::uint32_t count, float t_max) {
    scratch_.rays.resize(count);
    scratch_.rays.t_max = t_max;
    scratch_.active.assign((count + 31) / 32, 0);
    scratch_.blocked.resize(scratch_.active.size());
  }

  void set_ray(std::uint32_t i, Vec3f origin, Vec3f direction, bool is_active) {
    scratch_.rays.set(i, origin, direction);
    scratch_.active[i / 32] |= std::uint32_t{is_active} << i % 32;
  }

  const EmbreeBaseline& embree_;
  EmbreeVariant variant_;
  const ShadowScene& scene_;
  std::uint32_t light_;
  EmbreeScratch& scratch_;
  ShadowCounters& counters_;
};

}  // namespace

void embree_visibilities(const EmbreeBaseline& embree, EmbreeVariant variant,
                         const ShadowScene& scene, std::uint32_t light,
                         std::span<const ShadowQuery> queries, EmbreeScratch& scratch,
                         ShadowCounters& counters, std::span<Visibility> seen) {
  EmbreeAnswers answers(embree, variant, scene, light, scratch, counters);
  if (scene.method == Method::hard) return answers.hard(queries, seen);
  const bool is_one_ray = is_point(scene.lights[light]);
  const std::uint32_t d = is_one_ray ? 1 : scratch.points[0].pattern.size();
  if (d % full_call(variant) == 0) {
    for (std::size_t i = 0; i < queries.size(); ++i) seen[i] = answers.alone(queries[i]);
    return;
  }
  for (std::size_t first = 0; first < queries.size(); first += points_together) {
    const std::size_t count = std::min(points_together, queries.size() - first);
    answers.together(queries.subspan(first, count), seen.subspan(first, count));
  }
}

}  // namespace penumbra
