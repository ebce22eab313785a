// SPDX-License-Identifier: MIT
#include "bench_measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "image_difference.h"
#include "options.h"
#include "penumbra/geometry/placed_shape.h"
#include "penumbra/scene/error.h"
#include "penumbra/trace/prepare.h"
#include "penumbra/trace/verify.h"
#include "resources.h"

namespace penumbra {
namespace {

/// The value at a share of the way from the least to the most; between two, interpolated.
double quantile(std::span<const double> sorted, double share) {
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], at - static_cast<double>(below));
}

Timing timing(std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  return {quantile(seconds, 0.5), quantile(seconds, 0.25), quantile(seconds, 0.75)};
}

double median(const std::vector<double>& seconds) { return timing(seconds).median; }

/// What `make` gives; the median time of three goes, or the time of one that takes long.
template <class Make>
auto timed(double& seconds, Make make) {
  std::vector<double> times;
  for (;;) {
    const double start = now_seconds();
    auto made = make();
    times.push_back(now_seconds() - start);
    seconds = median(times);
    if (times.size() == 3 || times.back() > 0.5) return made;
  }
}

/// The shapes that block light, each where it stands.
ShapeSet casters_of(const Scene& scene) {
  const auto is_clear = [&](std::uint32_t surface) {
    return !scene.materials[surface].casts_shadow;
  };
  const auto is_clear_shape = [&](const auto& shape) { return is_clear(shape.surface); };
  ShapeSet casters = flattened(scene.shapes);
  std::erase_if(casters.spheres, is_clear_shape);
  std::erase_if(casters.cones, is_clear_shape);
  std::erase_if(casters.rings, is_clear_shape);
  for (Mesh& mesh : casters.meshes) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
      if (!is_clear(surface_of(mesh, i))) mesh.triangles[kept++] = mesh.triangles[i];
    mesh.triangles.resize(kept);
    mesh.surfaces.clear();
  }
  std::erase_if(casters.meshes, [](const Mesh& mesh) { return mesh.triangles.empty(); });
  return casters;
}

/// A scene of Embree's, and a way to ask it.
struct EmbreeWay {
  const EmbreeBuild* build = nullptr;
  EmbreeVariant variant;
};

std::string name_of(const EmbreeWay& way, const ShapeSet& shapes) {
  std::string name = name_of(way.variant);
  if (!shapes.spheres.empty())
    name += way.build->spheres == EmbreeSpheres::native ? ", native spheres" : ", user spheres";
  return name;
}

/// The fastest one, by a part of the work.
EmbreeWay best_way(const std::vector<EmbreeBuild>& builds, const ShadowScene& scene,
                   const ShadowWork& work, std::uint32_t shadow_samples, std::uint32_t threads) {
  constexpr std::size_t step = 7, rounds = 3;  // blocks stand in rows: not a multiple of 2
  const ShadowWork part = part_of(work, work.blocks.size() > 8 * step ? step : 1);
  std::vector<EmbreeWay> ways;
  for (const EmbreeBuild& build : builds)
    for (const EmbreeVariant variant : build.baseline.variants()) ways.push_back({&build, variant});
  std::vector<std::vector<double>> seconds(ways.size());
  for (std::size_t round = 0; round <= rounds; ++round)
    for (std::size_t i = 0; i < ways.size(); ++i) {
      std::vector<EmbreeWorker> workers(
          threads, EmbreeWorker(ways[i].build->baseline, ways[i].variant, scene, shadow_samples));
      const double took = answer_all(part, std::span(workers), {}).seconds;
      if (round > 0) seconds[i].push_back(took);  // the first round warms up
    }
  std::size_t best = 0;
  for (std::size_t i = 1; i < ways.size(); ++i)
    if (median(seconds[i]) < median(seconds[best])) best = i;
  return ways[best];
}

/// Names the first question that a method answers otherwise than the judge.
void check_identity(const std::string& scene, const ShadowWork& work, const RenderOptions& options,
                    std::string_view method, std::span<const Visibility> judge,
                    std::span<const Visibility> seen) {
  for (const ShadowBatch& batch : work.batches)
    for (std::size_t i = batch.first; i < batch.first + batch.count; ++i) {
      if (is_same_answer(judge[i], seen[i])) continue;
      const WrongAnswer wrong{{batch.path, batch.light, work.queries[i], seen[i]}, judge[i]};
      throw Error({scene, {}, {}}, fmt::format("{} is not stochastic, d = {}: {}", method,
                                               options.shadow_samples, to_text(wrong, options)));
    }
}

/// Share of the samples that only one of the two calls free.
double different_samples(std::span<const Visibility> a, std::span<const Visibility> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += std::abs(double{a[i].fraction} - double{b[i].fraction});
  return a.empty() ? 0 : sum / static_cast<double>(a.size());
}

/// A method of ours or a way to ask Embree, with all that its threads need.
struct Contestant {
  std::string name;
  const ShadowScene* shadows = nullptr;  // of a method of ours
  double build_seconds = 0;
  std::size_t geometry_bytes = 0, shadow_bytes = 0;
  std::vector<MethodWorker> ours;
  std::vector<EmbreeWorker> theirs;
  std::string variant;
  double different_samples = 0;
  std::vector<double> shadow_seconds, render_seconds;
  RenderCounters counters;

  double answer(const ShadowWork& work, std::span<Visibility> seen) {
    const WorkDone done = shadows ? answer_all(work, std::span(ours), seen)
                                  : answer_all(work, std::span(theirs), seen);
    counters.shadow = done.counters;
    return done.seconds;
  }
};

/// All methods of a scene with one d.
class Race {
 public:
  Race(const BenchScene& bench, std::uint32_t shadow_samples)
      : bench_(bench), options_(bench.options) {
    options_.shadow_samples = shadow_samples;
    for (std::size_t i = 0; i < bench.methods.size(); ++i) {
      if (bench.methods[i].method == Method::stochastic) judge_ = i;
      add_ours(bench.methods[i], bench.method_seconds[i]);
    }
    add_theirs("embree", bench.methods[judge_]);
    add_theirs("embree_hard", bench.hard);
  }

  /// The warm-up: every answer is kept and compared.
  void check(const std::string& name) {
    const std::size_t count = bench_.work.queries.size();
    std::vector<Visibility> judge(count), hard(count), seen(count);
    contestants_[judge_].answer(bench_.work, judge);
    std::vector<MethodWorker> to_center(options_.threads, MethodWorker(bench_.hard, 1));
    answer_all(bench_.work, std::span(to_center), hard);
    for (Contestant& one : contestants_) {
      one.answer(bench_.work, seen);
      if (!one.shadows)
        one.different_samples = different_samples(one.name == "embree" ? judge : hard, seen);
      else if (one.shadows->method != Method::hard)
        check_identity(name, bench_.work, options_, one.name, judge, seen);
    }
  }

  void run(const std::string& name, std::uint32_t rounds,
           const std::function<void(double)>& progress) {
    const std::size_t count = contestants_.size(), steps = 2 * count * rounds;
    std::size_t done = 0;
    const auto each_in_turn = [&](std::uint32_t round, auto&& act) {
      for (std::size_t i = 0; i < count; ++i) {
        act(contestants_[(i + round) % count]);
        progress(static_cast<double>(++done) / static_cast<double>(steps));
      }
    };
    std::vector<Image> pictures(count);
    for (std::uint32_t round = 0; round < rounds; ++round) {
      each_in_turn(round, [&](Contestant& one) {
        one.shadow_seconds.push_back(one.answer(bench_.work, {}));
      });
      each_in_turn(round, [&](Contestant& one) {
        if (!one.shadows) return;
        Picture picture = render(bench_.scene, *one.shadows, options_);
        one.render_seconds.push_back(picture.seconds.render);
        one.counters = picture.counters;
        if (round == 0)
          pictures[static_cast<std::size_t>(&one - contestants_.data())] = std::move(picture.image);
      });
      if (round == 0) check_pictures(name, std::exchange(pictures, {}));
    }
  }

  std::vector<BenchRow> rows() const {
    const auto shadow = [](const Contestant& one) { return median(one.shadow_seconds); };
    const Contestant &judge = contestants_[judge_], &embree = contestants_.end()[-2],
                     &embree_hard = contestants_.back();
    const double without_shadows = std::max(0.0, median(judge.render_seconds) - shadow(judge));
    std::vector<BenchRow> rows;
    for (const Contestant& one : contestants_) {
      std::vector<double> renders = one.render_seconds;
      if (!one.shadows)
        for (const double seconds : one.shadow_seconds)
          renders.push_back(without_shadows + seconds);
      rows.push_back({one.name, timing(one.shadow_seconds), timing(renders), one.build_seconds,
                      shadow(embree) / shadow(one), shadow(judge) / shadow(one),
                      shadow(one) / shadow(embree_hard), one.counters, one.geometry_bytes,
                      one.shadow_bytes, one.variant, one.different_samples});
    }
    return rows;
  }

 private:
  /// One of each contestant; Embree's are empty.
  void check_pictures(const std::string& name, const std::vector<Image>& pictures) const {
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      const ShadowScene* shadows = contestants_[i].shadows;
      if (!shadows || shadows->method == Method::hard) continue;
      if (difference(pictures[i], pictures[judge_], {}).pixels > 0)
        throw Error({name, {}, {}}, fmt::format("{} draws another picture than stochastic, d = {}",
                                                contestants_[i].name, options_.shadow_samples));
    }
  }

  void add_ours(const ShadowScene& shadows, double seconds) {
    Contestant one;
    one.name = name_of(Contender{shadows.method, shadows.rays});
    one.shadows = &shadows;
    one.build_seconds = bench_.kernel_seconds + seconds;
    one.geometry_bytes = bench_.kernel.memory_bytes();
    one.shadow_bytes = shadows.memory_bytes();
    one.ours.assign(options_.threads, MethodWorker(shadows, options_.shadow_samples));
    contestants_.push_back(std::move(one));
  }

  void add_theirs(const char* name, const ShadowScene& shadows) {
    const EmbreeWay way =
        best_way(bench_.embree, shadows, bench_.work, options_.shadow_samples, options_.threads);
    Contestant one;
    one.name = name;
    one.build_seconds = way.build->seconds;
    one.geometry_bytes = way.build->baseline.memory_bytes();
    one.theirs.assign(options_.threads, EmbreeWorker(way.build->baseline, way.variant, shadows,
                                                     options_.shadow_samples));
    one.variant = name_of(way, bench_.casters);
    contestants_.push_back(std::move(one));
  }

  const BenchScene& bench_;
  RenderOptions options_;
  std::size_t judge_ = 0;
  std::vector<Contestant> contestants_;
};

}  // namespace

std::string name_of(Contender contender) {
  return std::string(name_of(contender.method)) +
         (contender.rays == RayGrouping::single ? ", single rays" : "");
}

BenchScene::BenchScene(const Scene& scene_, const BenchMethods& wanted,
                       const RenderOptions& options_)
    : scene(scene_),
      options(options_),
      kernel(timed(kernel_seconds, [&] { return Kernel(scene.shapes, kernel_options(scene)); })),
      casters(casters_of(scene)),
      hard(prepare_shadows(scene, kernel, Method::hard)),
      work(record_shadow_work(scene, kernel, options)) {
  for (const EmbreeSpheres spheres : {EmbreeSpheres::native, EmbreeSpheres::user}) {
    const bool is_same = casters.spheres.empty() && !embree.empty();
    if (is_same || wanted.spheres.value_or(spheres) != spheres) continue;
    double seconds = 0;
    EmbreeBaseline baseline = timed(seconds, [&] { return EmbreeBaseline(casters, spheres); });
    embree.push_back({spheres, seconds, std::move(baseline)});
  }
  for (const Contender& contender : wanted.methods) {
    methods.push_back(timed(method_seconds.emplace_back(),
                            [&] { return prepare_shadows(scene, kernel, contender.method); }));
    methods.back().rays = contender.rays;
  }
}

std::vector<BenchRow> measure(const BenchScene& bench, const std::string& name,
                              std::uint32_t shadow_samples, std::uint32_t rounds,
                              const std::function<void(double)>& progress) {
  progress(0);
  if (bench.work.queries.empty())
    throw Error({name, {}, {}}, "the picture shows nothing that light could fall on",
                "turn the camera (render and bench have --from and --at)");
  Race race(bench, shadow_samples);
  race.check(name);
  race.run(name, rounds, progress);
  return race.rows();
}

}  // namespace penumbra
