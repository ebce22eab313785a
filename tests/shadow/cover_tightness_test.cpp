// SPDX-License-Identifier: MIT
// How much of the true umbra of one occluder is proven, by pair of shape and light
// (docs/method.md, How tight).
#include <cstdio>

#include "penumbra/shadow/cover.h"
#include "tests/shadow/cover_trials.h"
#include "tests/shadow/light_rays.h"
#include "tests/shadow/pairs.h"

namespace penumbra {
namespace {

using nasty::Random;
using trials::Occluder;

/// One occluder about as large as the light's shaft, one to ten times its extent from p and from
/// the light.
trials::CoverTrial typical_trial(const Occluder& occluder, const char* light_kind, Random& random) {
  const Vec3d way = random.direction();
  const double extent = length(Vec3d(bounds(occluder.record).size()));
  const double before = extent * double(random.power(0, 1)),
               behind = extent * double(random.power(0, 1));
  const Vec3f p(occluder.aim - way * before);
  const double size = occluder.size * (1 + behind / before) * double(random.power(-2, 0));
  return {make_light(light_kind, random_figure(random), occluder.aim + way * behind, size, p), p};
}

/// Of the trials whose 256 samples are all blocked, which share is proven.
double proven_share(const ShapeForm& form, const char* light_kind, int count) {
  static const SamplePattern pattern(256);
  Random random(200);
  int blocked = 0, proven = 0;
  while (blocked < count) {
    const Occluder occluder = trials::make_occluder(form, {}, random);
    const auto [light, p] = typical_trial(occluder, light_kind, random);
    if (contains(light, p)) continue;
    if (free_rays(occluder.record, judging_rays(light, p, pattern, 0, random)) > 0) continue;
    Box scene = bounds(occluder.record);
    scene.add(p);
    ++blocked, proven += surely_covers(occluder.record, LightHull(light, scene), p);
  }
  return double(proven) / count;
}

/// Slivers as thin as rounding hide nothing, cones flatter than 1 : 4 are never asked (cover.h).
double least_share(const ShapeForm& form) {
  return std::string_view(form.name) == "sliver" ? 0.5 : 0.85;
}

using CoverTightness = EveryPair;
using SlowCoverTightness = EveryPair;

TEST_P(CoverTightness, MostUmbraOfOneOccluderIsProven) {
  EXPECT_GT(proven_share(form(), light_kind(), 100), least_share(form()) - 0.1);
}

TEST_P(SlowCoverTightness, MostUmbraOfOneOccluderIsProven) {
  const double share = proven_share(form(), light_kind(), 20'000);
  std::printf("umbra %-16s %-14s %.4f\n", form().name, light_kind(), share);
  EXPECT_GT(share, least_share(form()));
}

INSTANTIATE_TEST_SUITE_P(Pairs, CoverTightness, every_pair(), name_of_pair);
INSTANTIATE_TEST_SUITE_P(Pairs, SlowCoverTightness, every_pair(), name_of_pair);

}  // namespace
}  // namespace penumbra
