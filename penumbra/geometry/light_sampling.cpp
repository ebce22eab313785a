// SPDX-License-Identifier: MIT
#include "penumbra/geometry/light_sampling.h"

#include <algorithm>
#include <cmath>

#include "penumbra/geometry/disk_sampling.h"
#include "penumbra/geometry/line_sampling.h"
#include "penumbra/geometry/parallelogram_sampling.h"
#include "penumbra/geometry/sample_loops.h"

namespace penumbra {
namespace {

void sample(const PointLight& light, Vec3f p, SampleArrays to) {
  const Vec3f way(Vec3d(light.center) - Vec3d(p));
  std::fill_n(to.x, to.count, way.x);
  std::fill_n(to.y, to.count, way.y);
  std::fill_n(to.z, to.count, way.z);
}

Frame<float> rounded(const Frame<double>& f) { return {Vec3f(f.u), Vec3f(f.v), Vec3f(f.n)}; }

void sample_from_inside(const BallLight& ball, Vec3d to_center, SampleArrays to) {
  // At most 1: what float cannot tell from the surface counts as on it.
  const double distance = ball.radius > 0 ? std::min(1.0, length(to_center) / ball.radius) : 0;
  const Vec3d axis = normalize(to_center);
  InsideBallSampling inside;
  inside.frame = rounded(frame_around(axis == Vec3d{} ? Vec3d(0, 0, 1) : axis));
  inside.radius = ball.radius;
  inside.distance = static_cast<float>(distance);
  inside.power = static_cast<float>((1 - distance) * (1 + distance));
  sample_ball_from_inside(inside, to);
}

void sample(const BallLight& ball, Vec3f p, SampleArrays to) {
  const Vec3d to_center = Vec3d(ball.center) - Vec3d(p);
  if (contains(ball, p)) return sample_from_inside(ball, to_center, to);
  const double distance = length(to_center), radius = ball.radius, sine = radius / distance;
  const double cosine = std::sqrt((distance - radius) * (distance + radius)) / distance;
  const double one_minus_cos = sine * sine / (1 + cosine);
  BallSampling outside;
  outside.cone.frame = rounded(frame_around(to_center / distance));
  outside.cone.one_minus_cos = static_cast<float>(one_minus_cos);
  outside.cone.root = static_cast<float>(sine / std::sqrt(1 + cosine));
  outside.nearest = static_cast<float>(distance * cosine * cosine);
  // Small lights are measured from their centre, so that the shape survives beside a large
  // distance; near ones from p, so that a short ray keeps its direction.
  if (sine < 0.5) {
    outside.base = Vec3f(to_center);
    outside.of_cos = static_cast<float>(-distance * sine * sine);
    outside.of_q = static_cast<float>(-distance);
  } else {
    outside.of_cos = outside.nearest;
  }
  sample_ball(outside, to);
}

void sample(const ParallelogramLight& light, Vec3f p, SampleArrays to) {
  sample_parallelogram(light, p, to);
}

void sample(const DiskLight& light, Vec3f p, SampleArrays to) { sample_disk(light, p, to); }
void sample(const LineLight& light, Vec3f p, SampleArrays to) { sample_line(light, p, to); }

void sample(const PolygonLight& light, Vec3f p, SampleArrays to,
            std::vector<SampledTriangle>& scratch) {
  sample_polygon(light, p, to, scratch);
}

void sample(const MeshLight& light, Vec3f p, SampleArrays to,
            std::vector<SampledTriangle>& scratch) {
  sample_mesh(light, p, to, scratch);
}

void sample(const SunLight& sun, Vec3f, SampleArrays to) {
  const double s = std::sin(0.5 * static_cast<double>(sun.half_angle_rad));
  ConeSampling cone;
  cone.frame = rounded(frame_around(normalize(Vec3d(sun.direction))));
  cone.one_minus_cos = static_cast<float>(2 * s * s);
  cone.root = static_cast<float>(std::sqrt(2.0) * s);
  sample_cone(cone, to);
}

}  // namespace

void LightSamples::resize(std::uint32_t d) {
  const std::size_t padded = (std::size_t{d} + padding - 1) / padding * padding;
  count = d;
  x.resize(padded);
  y.resize(padded);
  z.resize(padded);
}

void sample_light(const LightShape& light, Vec3f p, const SamplePattern& pattern, std::uint64_t key,
                  LightSamples& out) {
  const std::uint32_t d = pattern.size();
  out.resize(d);
  out.origin = p;
  out.t_max = std::holds_alternative<SunLight>(light) ? std::numeric_limits<float>::infinity() : 1;
  if (d == 0) return;
  // The loops turn (u, v) into samples in place, padding included.
  pattern.scramble(key, std::span(out.x).first(d), std::span(out.y).first(d));
  std::fill(out.x.begin() + d, out.x.end(), out.x[d - 1]);
  std::fill(out.y.begin() + d, out.y.end(), out.y[d - 1]);
  const SampleArrays arrays{out.x.data(), out.y.data(), out.z.data(), out.x.size()};
  std::visit(
      [&](const auto& shape) {
        if constexpr (requires { sample(shape, p, arrays); })
          sample(shape, p, arrays);
        else
          sample(shape, p, arrays, out.scratch);
      },
      light);
}

}  // namespace penumbra
