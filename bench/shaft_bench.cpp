// SPDX-License-Identifier: MIT
// The steps of the shaft method, each by itself, on the receivers of gallery pictures: what lanes
// see of the light, the query, the tests of candidates, sheets, and the samples against a list.
#include <benchmark/benchmark.h>

#include <map>
#include <memory>
#include <string>

#include "penumbra/geometry/surface_point.h"
#include "penumbra/scene/complete_scene.h"
#include "penumbra/scene/gallery.h"
#include "penumbra/shadow/samples.h"
#include "penumbra/shadow/shaft.h"
#include "penumbra/shadow/sift.h"
#include "penumbra/trace/prepare.h"

namespace penumbra {
namespace {

constexpr std::uint32_t light = 0;

/// Tiles of 8 x 8 camera hits; only whole ones.
struct Workload {
  Workload(const std::string& name, float radius_percent)
      : scene(complete_scene(*gallery_scene(name), options(radius_percent))),
        kernel(scene.shapes, kernel_options(scene)),
        shadows(prepare_shadows(scene, kernel, Method::shaft)) {
    constexpr int size = 256, edge = 8;
    for (int y = 0; y < size; y += edge)
      for (int x = 0; x < size; x += edge) {
        std::vector<ShadowQuery> tile;
        for (int i = 0; i < edge * edge; ++i) add_hit(x + i % edge, y + i / edge, size, tile);
        if (tile.size() == edge * edge) tiles.push_back(tile);
      }
    rows.resize(tiles.size());
    for (std::size_t i = 0; i < tiles.size(); ++i)
      see_light(shadows.forms[light], tiles[i], shadows.receivers, rows[i]);
  }

  static SceneOptions options(float radius_percent) {
    SceneOptions options;
    options.light_radius = LightRadius{radius_percent, true};
    return options;
  }

  void add_hit(int x, int y, int size, std::vector<ShadowQuery>& tile) const {
    const CameraFrame f = frame(*scene.camera, 1);
    const Vec3d direction =
        f.forward + f.right * (2 * (x + 0.5) / size - 1) - f.up * (2 * (y + 0.5) / size - 1);
    const auto hit = kernel.closest({Vec3f(f.origin), Vec3f(direction)}).hit;
    if (!hit) return;
    const SurfacePoint point = surface_point(scene.shapes, hit->shape, f.origin, direction, hit->t);
    tile.push_back({{receiver_position(point), Vec3f(point.normal)},
                    static_cast<std::uint64_t>(y * size + x)});
  }

  Scene scene;
  Kernel kernel;
  ShadowScene shadows;
  std::vector<std::vector<ShadowQuery>> tiles;
  std::vector<ReceiverRows> rows;  // of the tiles
};

/// Calls step(group) for one tile after another.
template <class Step>
void run(benchmark::State& state, const Workload& work, Step&& step) {
  std::size_t tile = 0;
  for (auto _ : state) {
    const ReceiverRows& rows = work.rows[tile++ % work.rows.size()];
    step(ReceiverGroup{rows, 0, rows.count, false});
  }
}

void add_all(const std::string& name, float radius_percent) {
  static std::map<std::string, std::unique_ptr<Workload>> works;
  const std::string scene = name + "/" + std::to_string(static_cast<int>(radius_percent)) + "%";
  auto& work = works[scene];
  work = std::make_unique<Workload>(name, radius_percent);
  const Workload& w = *work;
  const LightForm& form = w.shadows.forms[light];
  const auto add = [&](const char* step, auto function) {
    benchmark::RegisterBenchmark((std::string(step) + "/" + scene).c_str(), function);
  };
  add("see_light, 64 receivers", [&](benchmark::State& state) {
    auto rows = std::make_unique<ReceiverRows>();
    std::size_t tile = 0;
    for (auto _ : state)
      benchmark::DoNotOptimize(
          see_light(form, w.tiles[tile++ % w.tiles.size()], w.shadows.receivers, *rows));
  });
  const auto gather = [&](const ReceiverGroup& group, CandidateList& list) {
    std::uint64_t tests = 0;
    return gather_candidates(w.shadows, light, group.bounds(), seen_by_all(form, group),
                             CandidateList::most, list, tests);
  };
  add("query of a tile", [&, gather](benchmark::State& state) {
    auto list = std::make_unique<CandidateList>();
    run(state, w,
        [&](const ReceiverGroup& group) { benchmark::DoNotOptimize(gather(group, *list)); });
  });
  add("query and candidates of a tile", [&, gather](benchmark::State& state) {
    auto list = std::make_unique<CandidateList>(), left = std::make_unique<CandidateList>();
    run(state, w, [&](const ReceiverGroup& group) {
      if (gather(group, *list))
        benchmark::DoNotOptimize(sift_for_all(*list, seen_by_all(form, group), *left));
    });
  });
  add("query and candidates of one", [&](benchmark::State& state) {
    auto list = std::make_unique<CandidateList>();
    Sifted sifted;
    run(state, w, [&](const ReceiverGroup& group) {
      const SeenLight seen = seen_by_one(form, group.rows, 0);
      std::uint64_t tests = 0;
      if (gather_candidates(w.shadows, light, ReceiverGroup{group.rows, 0, 1, false}.bounds(), seen,
                            CandidateList::most, *list, tests))
        sift(*list, seen, sifted);
    });
  });
  add("sheet of a tile", [&](benchmark::State& state) {
    auto scratch = std::make_unique<SheetScratch>();
    run(state, w, [&](const ReceiverGroup& group) {
      const SeenLight seen = seen_by_all(form, group);
      std::uint64_t tests = 0;
      const std::uint32_t start = w.kernel.closest_record({seen.p, seen.way, 0, 1});
      if (start != no_record)
        benchmark::DoNotOptimize(sheet_covers(*w.shadows.sheet, w.kernel.records(), seen, start,
                                              SheetScratch::most, *scratch, tests));
    });
  });
  add("32 samples, taken and weighed", [&](benchmark::State& state) {
    SampleScratch samples(32);
    std::size_t tile = 0;
    for (auto _ : state) {
      const ShadowQuery& query = w.tiles[tile++ % w.tiles.size()].front();
      benchmark::DoNotOptimize(take_samples(w.shadows, light, query.receiver, query.key, samples));
    }
  });
  add("32 samples against 8 records", [&](benchmark::State& state) {
    SampleScratch samples(32);
    const ShadowQuery& query = w.tiles.front().front();
    take_samples(w.shadows, light, query.receiver, query.key, samples);
    std::vector<std::uint32_t> blocked(1), records(8);
    std::uint32_t first = 0;
    for (auto _ : state) {
      for (std::uint32_t& record : records)
        record = first++ % static_cast<std::uint32_t>(w.kernel.records().size());
      benchmark::DoNotOptimize(
          occluded_among(w.kernel.records(), records, samples.samples, samples.active, blocked));
    }
  });
}

}  // namespace
}  // namespace penumbra

int main(int argc, char** argv) {
  for (const char* scene : {"balls:4", "molecule", "bust"}) penumbra::add_all(scene, 5);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
