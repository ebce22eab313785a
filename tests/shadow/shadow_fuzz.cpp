// SPDX-License-Identifier: MIT
// shadow_fuzz [SECONDS [SEED]]: random scenes, all methods against brute force, bit for bit, for as
// long as it is given. A failure names the seed that repeats it alone (SECONDS 0).
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/shadow/random_scene.h"

namespace penumbra {
namespace {

struct Tally {
  std::uint64_t scenes = 0, queries = 0;
  ShadowCounters proven;
};

bool same(const Visibility& a, const Visibility& b) {
  return a.cosine_weighted == b.cosine_weighted && a.fraction == b.fraction;
}

/// One scene; false at the first difference.
bool agree(std::uint64_t seed, Tally& tally) {
  nasty::Random random(seed);
  const nasty::RandomScene scene = nasty::random_scene(random);
  const KernelOptions by_brute{KernelKind::brute, scene.options.casts_no_shadow};
  const Kernel brute(scene.shapes, by_brute), wide(scene.shapes, scene.options);
  const ShadowScene judge =
      prepare_shadows(brute, scene.shapes, by_brute, scene.lights, Method::stochastic);
  std::vector<ShadowScene> methods;
  for (const Method method : {Method::offset, Method::reduced, Method::umbra})
    methods.push_back(prepare_shadows(wide, scene.shapes, scene.options, scene.lights, method));
  VisibilityScratch scratch(1 + random.below(70));
  OccluderCache cache(scene.lights.size());
  ShadowCounters ignored;
  for (std::uint64_t point = 0; point < 60; ++point) {
    const Receiver receiver = nasty::random_receiver(scene, wide, random);
    for (std::uint32_t light = 0; light < scene.lights.size(); ++light) {
      OccluderQueue none;
      const Visibility truth = visibility(judge, light, receiver, point, none, scratch, ignored);
      for (const ShadowScene& method : methods) {
        const auto path = static_cast<std::uint64_t>(method.method);
        const Visibility seen = visibility(method, light, receiver, point, cache.queue(path, light),
                                           scratch, tally.proven);
        if (same(truth, seen)) continue;
        std::fprintf(stderr,
                     "seed %llu, method %d, point %llu, light %u: fraction %.9g instead of %.9g\n",
                     static_cast<unsigned long long>(seed), static_cast<int>(method.method),
                     static_cast<unsigned long long>(point), light, double(seen.fraction),
                     double(truth.fraction));
        return false;
      }
      ++tally.queries;
    }
  }
  ++tally.scenes;
  return true;
}

}  // namespace
}  // namespace penumbra

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 10;
  std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  const auto start = std::chrono::steady_clock::now();
  penumbra::Tally tally;
  do {
    if (!penumbra::agree(seed++, tally)) return 1;
  } while (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() <
           seconds);
  std::printf("%llu scenes, %llu queries; by three methods %llu lit, %llu umbra, %llu penumbra\n",
              static_cast<unsigned long long>(tally.scenes),
              static_cast<unsigned long long>(tally.queries),
              static_cast<unsigned long long>(tally.proven.lit),
              static_cast<unsigned long long>(tally.proven.umbra),
              static_cast<unsigned long long>(tally.proven.penumbra));
  return 0;
}
