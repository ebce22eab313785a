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
  ShadowCounters by_sets, by_shafts;
};

bool same(const Visibility& a, const Visibility& b) {
  return a.cosine_weighted == b.cosine_weighted && a.fraction == b.fraction;
}

std::uint64_t queries_of(const ShadowCounters& counters) {
  return counters.lit + counters.penumbra + counters.umbra;
}

/// One random scene, the judge and the methods.
class Contest {
 public:
  explicit Contest(std::uint64_t seed)
      : seed_(seed),
        random_(seed),
        scene_(nasty::random_scene(random_)),
        by_brute_{KernelKind::brute, scene_.options.casts_no_shadow},
        brute_(scene_.shapes, by_brute_),
        wide_(scene_.shapes, scene_.options),
        judge_(
            prepare_shadows(brute_, scene_.shapes, by_brute_, scene_.lights, Method::stochastic)),
        scratch_(1 + random_.below(random_.one_in(4) ? 300 : 70)) {}

  /// False at the first difference.
  bool is_even(Tally& tally) {
    const bool is_long = random_.one_in(6);
    ask(1 + random_.below(is_long ? 256 : 60));
    for (const Method method : {Method::offset, Method::reduced, Method::umbra})
      if (!agrees(method, 1, tally.by_sets)) return false;
    // Together, and cut anywhere.
    if (!agrees(Method::shaft, queries_.size(), tally.by_shafts)) return false;
    const std::uint32_t batch = 1 + random_.below(100);
    if (!agrees(Method::shaft, batch, tally.by_shafts)) return false;
    ++tally.scenes, tally.queries += queries_.size() * scene_.lights.size();
    return true;
  }

 private:
  void ask(std::uint32_t count) {
    for (const Receiver& receiver : nasty::random_receivers(scene_, wide_, count, random_))
      queries_.push_back({receiver, queries_.size()});
    for (std::uint32_t light = 0; light < scene_.lights.size(); ++light)
      for (const ShadowQuery& query : queries_) {
        OccluderQueue none;
        truth_.push_back(
            visibility(judge_, light, query.receiver, query.key, none, scratch_, asked_));
      }
  }

  /// Asks in batches.
  bool agrees(Method method, std::size_t batch, ShadowCounters& total) {
    const ShadowScene shadows =
        prepare_shadows(wide_, scene_.shapes, scene_.options, scene_.lights, method);
    ShadowCounters counters;
    std::vector<Visibility> seen(queries_.size());
    for (std::uint32_t light = 0; light < scene_.lights.size(); ++light) {
      OccluderQueue queue;
      for (std::size_t first = 0; first < queries_.size(); first += batch) {
        const std::size_t count = std::min(batch, queries_.size() - first);
        visibilities(shadows, light, std::span(queries_).subspan(first, count), queue, scratch_,
                     counters, std::span(seen).subspan(first, count));
      }
      for (std::size_t i = 0; i < seen.size(); ++i)
        if (!same(truth_[light * seen.size() + i], seen[i]))
          return differs(method, batch, light, i, seen[i]);
    }
    total.add(counters);
    if (queries_of(counters) == queries_of(asked_)) return true;
    std::fprintf(stderr, "seed %llu, method %d, batches of %zu: counts other queries\n",
                 static_cast<unsigned long long>(seed_), static_cast<int>(method), batch);
    return false;
  }

  bool differs(Method method, std::size_t batch, std::uint32_t light, std::size_t point,
               const Visibility& seen) const {
    const Visibility& truth = truth_[light * queries_.size() + point];
    std::fprintf(stderr,
                 "seed %llu, method %d, batches of %zu, point %zu, light %u: class %d, fraction "
                 "%.9g instead of %.9g\n",
                 static_cast<unsigned long long>(seed_), static_cast<int>(method), batch, point,
                 light, static_cast<int>(seen.shadow_class), double(seen.fraction),
                 double(truth.fraction));
    return false;
  }

  std::uint64_t seed_;
  nasty::Random random_;
  nasty::RandomScene scene_;
  KernelOptions by_brute_;
  Kernel brute_, wide_;
  ShadowScene judge_;
  VisibilityScratch scratch_;
  std::vector<ShadowQuery> queries_;
  std::vector<Visibility> truth_;  // light by light
  ShadowCounters asked_;
};

void print(const char* who, const ShadowCounters& counters) {
  std::printf("%s: %llu lit, %llu umbra, %llu penumbra\n", who,
              static_cast<unsigned long long>(counters.lit),
              static_cast<unsigned long long>(counters.umbra),
              static_cast<unsigned long long>(counters.penumbra));
}

}  // namespace
}  // namespace penumbra

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 10;
  std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  const auto start = std::chrono::steady_clock::now();
  penumbra::Tally tally;
  do {
    if (!penumbra::Contest(seed++).is_even(tally)) return 1;
  } while (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() <
           seconds);
  std::printf("%llu scenes, %llu queries\n", static_cast<unsigned long long>(tally.scenes),
              static_cast<unsigned long long>(tally.queries));
  penumbra::print("three methods by shadow sets", tally.by_sets);
  penumbra::print("shafts, twice", tally.by_shafts);
  return 0;
}
