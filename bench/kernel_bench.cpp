// SPDX-License-Identifier: MIT
// Closest hits and any hits, ours beside Embree's, on the receivers of gallery pictures. Ratios
// within one run are what counts: run with --benchmark_enable_random_interleaving=true
// --benchmark_repetitions=5.
#include <benchmark/benchmark.h>

#include <map>
#include <string>

#include "penumbra/geometry/surface_point.h"
#include "penumbra/kernel/embree_baseline.h"
#include "penumbra/kernel/kernel.h"
#include "penumbra/scene/complete_scene.h"
#include "penumbra/scene/gallery.h"

namespace penumbra {
namespace {

/// A scene's camera rays at 128 x 128, and the samples of its first light from every point they
/// hit.
struct Workload {
  Workload(const std::string& name, float radius_percent, std::uint32_t d)
      : scene(complete_scene(*gallery_scene(name), options(radius_percent))),
        kernel(scene.shapes, {}),
        embree(scene.shapes) {
    constexpr int size = 128;
    const CameraFrame f = frame(*scene.camera, 1);
    const SamplePattern pattern(d);
    for (int i = 0; i < size * size; ++i) {
      const Vec3d direction = f.forward + f.right * (2 * (i % size + 0.5) / size - 1) -
                              f.up * (2 * (i / size + 0.5) / size - 1);
      camera_rays.push_back({Vec3f(f.origin), Vec3f(direction)});
      const auto hit = kernel.closest(camera_rays.back()).hit;
      if (hit)
        add_packet(surface_point(scene.shapes, hit->shape, f.origin, direction, hit->t), pattern);
    }
  }

  static SceneOptions options(float radius_percent) {
    SceneOptions options;
    options.light_radius = LightRadius{radius_percent, true};
    return options;
  }

  void add_packet(const SurfacePoint& point, const SamplePattern& pattern) {
    LightSamples s;
    sample_light(scene.lights[0].shape, receiver_position(point), pattern, packets.size(), s);
    std::vector<std::uint32_t> above((s.count + 31) / 32, 0);
    for (std::uint32_t i = 0; i < s.count; ++i)
      if (dot(point.normal, Vec3d{s.x[i], s.y[i], s.z[i]}) > 0) above[i / 32] |= 1u << i % 32;
    packets.push_back(std::move(s));
    active.push_back(std::move(above));
  }

  Scene scene;
  Kernel kernel;
  EmbreeBaseline embree;
  std::vector<Ray> camera_rays;
  std::vector<LightSamples> packets;
  std::vector<std::vector<std::uint32_t>> active;
};

template <typename Closest>
void run_closest(benchmark::State& state, const Workload& work, Closest&& closest) {
  for (auto _ : state)
    for (const Ray& ray : work.camera_rays) benchmark::DoNotOptimize(closest(ray));
  state.counters["us_per_ray"] = benchmark::Counter(
      static_cast<double>(work.camera_rays.size()) * 1e-6,
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <typename Occluded>
void run_occluded(benchmark::State& state, const Workload& work, Occluded&& occluded) {
  std::vector<std::uint32_t> blocked(work.active.front().size());
  for (auto _ : state)
    for (std::size_t i = 0; i < work.packets.size(); ++i) {
      occluded(work.packets[i], work.active[i], std::span(blocked));
      benchmark::DoNotOptimize(blocked.data());
    }
  state.counters["us_per_point"] = benchmark::Counter(
      static_cast<double>(work.packets.size()) * 1e-6,
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void add_all(const std::string& scene, float radius_percent, std::uint32_t d) {
  const auto work = std::make_shared<Workload>(scene, radius_percent, d);
  const std::string suffix = "/" + scene +
                             "/radius:" + std::to_string(static_cast<int>(radius_percent)) +
                             "%/d:" + std::to_string(d);
  const auto occluded = [&](const std::string& name, auto function) {
    benchmark::RegisterBenchmark((name + suffix).c_str(), [=](benchmark::State& state) {
      run_occluded(state, *work, [&](auto&&... arguments) { function(*work, arguments...); });
    })->Unit(benchmark::kMillisecond);
  };
  using Words = std::span<const std::uint32_t>;
  using Out = std::span<std::uint32_t>;
  occluded("occluded", [](const Workload& w, const LightSamples& r, Words a, Out b) {
    w.kernel.occluded(r, a, b);
  });
  for (const EmbreeVariant variant : work->embree.variants())
    occluded(name_of(variant), [=](const Workload& w, const LightSamples& r, Words a, Out b) {
      w.embree.occluded(variant, r, a, b);
    });
  if (radius_percent > 1 || d > 32) return;
  benchmark::RegisterBenchmark(("closest/" + scene).c_str(), [=](benchmark::State& state) {
    run_closest(state, *work, [&](const Ray& ray) { return work->kernel.closest(ray); });
  })->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark(("rtcIntersect1/" + scene).c_str(), [=](benchmark::State& state) {
    run_closest(state, *work, [&](const Ray& ray) { return work->embree.closest(ray); });
  })->Unit(benchmark::kMillisecond);
}

}  // namespace
}  // namespace penumbra

int main(int argc, char** argv) {
  for (const char* scene : {"balls:4", "molecule", "bust"})
    for (float percent : {1.0f, 5.0f, 15.0f, 50.0f}) penumbra::add_all(scene, percent, 32);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
