// SPDX-License-Identifier: MIT
// shadow_fuzz [SECONDS [SEED]]: random scenes, all methods against brute force, bit for bit, for as
// long as it is given. A failure names the seed that repeats it alone (SECONDS 0).
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "penumbra/shadow/hull_proof.h"
#include "tests/shadow/random_scene.h"

namespace penumbra {
namespace {

struct Tally {
  std::uint64_t scenes = 0, queries = 0;
  ShadowCounters by_sets, by_shafts;
  std::uint64_t hulls[3] = {};  ///< by class
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
    if (!has_same_samples() || !is_right_of_hulls(tally)) return false;
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

  /// The same samples are free as those of the judge, and classes are true where they alone are
  /// wanted. By the shaft method, its scenes made light by light.
  bool has_same_samples() {
    const ShadowScene base =
        prepare_shadows(wide_, scene_.shapes, scene_.options, {}, Method::shaft);
    const std::uint32_t d = scratch_.samples.pattern.size();
    const std::size_t words = (d + 31) / 32, count = queries_.size();
    std::vector<Visibility> seen(count), classes(count);
    std::vector<std::uint32_t> free(count * words), truth(count * words);
    const auto ask = [&](const ShadowScene& scene, std::uint32_t light, const AnswerRows& rows) {
      OccluderQueue queue;
      ShadowCounters counters;
      visibilities(scene, light, queries_, queue, scratch_, counters, rows);
    };
    for (std::uint32_t light = 0; light < scene_.lights.size(); ++light) {
      Box around;  // some of the receivers', and more
      if (random_.one_in(2))
        for (int i = 0; i < 2; ++i)
          around.add(scene_.place(random_.in_cube() * random_.power(-1, 3)));
      const ShadowScene one = with_light(base, scene_.lights[light], Method::shaft, around);
      ask(judge_, light, {.seen = seen, .free_samples = truth, .shadow_samples = d});
      ask(one, 0, {.seen = seen, .free_samples = free, .shadow_samples = d});
      ask(one, 0, {.seen = classes, .wanted = Wanted::shadow_class});
      for (std::size_t i = 0; i < count; ++i)
        if (const Visibility& one_truth = truth_[light * count + i];
            !same(seen[i], one_truth) ||
            !is_true(classes[i].shadow_class, light, i, std::span(truth).subspan(i * words, words)))
          return differs(Method::shaft, 0, light, i, classes[i]);
      if (free != truth) return differs(Method::shaft, 0, light, 0, seen[0]);
    }
    return true;
  }

  /// Lit: every sample above the horizon is free. Umbra: none is.
  bool is_true(ShadowClass proven, std::uint32_t light, std::size_t query,
               std::span<const std::uint32_t> free) {
    if (proven == ShadowClass::penumbra) return true;
    if (proven == ShadowClass::umbra)
      return std::all_of(free.begin(), free.end(), [](std::uint32_t word) { return word == 0; });
    take_samples(judge_, light, queries_[query].receiver, queries_[query].key, scratch_.samples);
    const std::vector<std::uint32_t>& active = scratch_.samples.active;
    // A point light has one sample for all of d.
    if (scratch_.samples.samples.count == 1) return (active[0] & ~free[0] & 1) == 0;
    return std::equal(active.begin(), active.end(), free.begin(), free.end());
  }

  /// What is proven of the hull of some receivers holds for points in it.
  bool is_right_of_hulls(Tally& tally) {
    const ShadowScene shadows =
        prepare_shadows(wide_, scene_.shapes, scene_.options, scene_.lights, Method::shaft);
    const std::size_t first = random_.below(static_cast<std::uint32_t>(queries_.size()));
    const std::size_t most = std::min<std::size_t>(queries_.size() - first, 1 + random_.below(64));
    std::vector<Receiver> corners;
    const float spread = random_.power(-6, 0);
    const bool has_horizon = random_.one_in(2);
    for (std::size_t i = first; i < first + most; ++i) {
      const Receiver &at = queries_[first].receiver, &other = queries_[i].receiver;
      corners.push_back({at.position + (other.position - at.position) * spread,
                         has_horizon ? at.normal : Vec3f{}});
    }
    for (std::uint32_t light = 0; light < scene_.lights.size(); ++light) {
      OccluderQueue queue;
      ShadowCounters counters;
      const HullProof proof = prove_hull(shadows, light, corners, queue, scratch_, counters);
      ++tally.hulls[static_cast<int>(proof.shadow_class)];
      if (proof.shadow_class == ShadowClass::penumbra) continue;
      for (int k = 0; k < 8; ++k)
        if (!holds_for(proof, light, point_in(corners))) return false;
    }
    return true;
  }

  /// Of their hull; often a corner, or on an edge.
  Receiver point_in(const std::vector<Receiver>& corners) {
    Receiver inside = corners[random_.below(static_cast<std::uint32_t>(corners.size()))];
    for (std::uint32_t k = 0, steps = random_.below(4); k < steps; ++k) {
      const Receiver& to = corners[random_.below(static_cast<std::uint32_t>(corners.size()))];
      const float t = random_.uniform(0, 1);
      inside.position = inside.position * (1 - t) + to.position * t;
    }
    return inside;
  }

  bool holds_for(const HullProof& proof, std::uint32_t light, const Receiver& receiver) {
    OccluderQueue none;
    take_samples(judge_, light, receiver, 7, scratch_.samples);
    const std::vector<std::uint32_t> active = scratch_.samples.active;
    const Visibility truth =
        visibility(judge_, light, receiver, 7, none, scratch_, asked_in_hulls_);
    bool is_free = true;  // all active samples
    for (std::size_t word = 0; word < active.size() && truth.fraction > 0; ++word)
      is_free &= (active[word] & scratch_.samples.blocked[word]) == 0;
    const bool is_none_active =
        std::all_of(active.begin(), active.end(), [](std::uint32_t bits) { return bits == 0; });
    const bool holds = proof.shadow_class == ShadowClass::umbra
                           ? truth.fraction == 0
                           : (is_none_active || (truth.fraction > 0 && is_free));
    if (holds && !(proof.is_above && proof.shadow_class == ShadowClass::lit && truth.fraction < 1))
      return true;
    std::fprintf(stderr, "seed %llu, light %u: a hull of class %d has a point of fraction %.9g\n",
                 static_cast<unsigned long long>(seed_), light,
                 static_cast<int>(proof.shadow_class), double(truth.fraction));
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
  ShadowCounters asked_, asked_in_hulls_;
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
  std::printf("hulls: %llu lit, %llu umbra, %llu penumbra\n",
              static_cast<unsigned long long>(tally.hulls[0]),
              static_cast<unsigned long long>(tally.hulls[2]),
              static_cast<unsigned long long>(tally.hulls[1]));
  return 0;
}
