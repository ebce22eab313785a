// SPDX-License-Identifier: MIT
// Measures all methods, and Embree, on the shadow work of one scene.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench_report.h"
#include "penumbra/trace/shadow_work.h"

namespace penumbra {

/// One of our methods.
struct Contender {
  Method method = Method::stochastic;
  RayGrouping rays = RayGrouping::packets;
  friend bool operator==(const Contender&, const Contender&) = default;
};

/// "umbra", "umbra, single rays"
std::string name_of(Contender contender);

/// What is measured. `methods` hold `stochastic`.
struct BenchMethods {
  std::vector<Contender> methods;
  std::optional<EmbreeSpheres> spheres;  ///< none: either, whichever is faster
};

/// A scene of Embree's.
struct EmbreeBuild {
  EmbreeSpheres spheres;
  double seconds;
  EmbreeBaseline baseline;
};

/// A scene, prepared for all methods and for Embree.
struct BenchScene {
  /// `scene` must be complete and live as long. Builds are timed, on as many threads as TBB allows.
  BenchScene(const Scene& scene, const BenchMethods& wanted, const RenderOptions& options);

  const Scene& scene;
  RenderOptions options;
  double kernel_seconds = 0;
  Kernel kernel;
  ShapeSet casters;                 ///< the shapes that block light: what Embree gets
  std::vector<EmbreeBuild> embree;  ///< one, or one for each kind of spheres
  std::vector<ShadowScene> methods;
  std::vector<double> method_seconds;  ///< of what they prepare beside the kernel
  ShadowScene hard;                    ///< whether or not it is one of the methods
  ShadowWork work;
};

/// `rounds` of all methods, interleaved, on `options.threads` threads. `progress` is told the
/// finished share. Throws Error, which begins with `name`, when the answers of a method are not
/// those of `stochastic`.
std::vector<BenchRow> measure(const BenchScene& bench, const std::string& name,
                              std::uint32_t shadow_samples, std::uint32_t rounds,
                              const std::function<void(double)>& progress);

}  // namespace penumbra
