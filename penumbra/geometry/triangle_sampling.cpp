// SPDX-License-Identifier: MIT
#include "penumbra/geometry/triangle_sampling.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "penumbra/geometry/least_solid_angle.h"
#include "penumbra/geometry/replace_samples.h"

namespace penumbra {
namespace {

double area_of(const SeenTriangle& seen) { return length(cross(seen.to_second, seen.to_third)); }

/// Those of the light's triangles that `is_wanted` lets pass.
void gather(const auto& light, Vec3f p, const auto& is_wanted, std::vector<SampledTriangle>& to) {
  to.clear();
  for (std::size_t i = 0; i < triangle_count(light); ++i) {
    const SeenTriangle seen = seen_triangle(light, i, p);
    if (!is_wanted(seen)) continue;
    SampledTriangle& triangle = to.emplace_back();
    triangle.seen = seen;
    triangle.solid_angle = solid_angle(seen);
  }
}

/// Shares by solid angle; by area where that says nothing (also where p is not a number).
/// Returns their sum.
double set_shares(std::vector<SampledTriangle>& triangles, bool is_by_area) {
  double sum = 0;
  for (SampledTriangle& t : triangles) {
    if (is_by_area) t.solid_angle = 0;
    t.share_end = sum += is_by_area ? area_of(t.seen) : t.solid_angle;
  }
  if (is_by_area || sum > 0) return sum;
  return set_shares(triangles, true);
}

void prepare(SampledTriangle& t) {
  const Vec3d a = t.seen.corner, second = t.seen.to_second, third = t.seen.to_third;
  t.is_ready = true;
  t.sphere = spherical_triangle(a + second, a, a + third, t.solid_angle);
  t.normal = cross(second, third);
  t.for_second = cross(third, t.normal) / length_squared(t.normal);
  t.for_third = cross(t.normal, second) / length_squared(t.normal);
}

/// NaN becomes 0.
double to_unit(double x) { return std::min(1.0, std::max(0.0, x)); }

/// Weights of the edges, which rounding cannot put outside the triangle.
Vec3f on_triangle(const SeenTriangle& seen, double of_second, double of_third) {
  const double b = to_unit(of_second), c = std::min(to_unit(of_third), 1 - b);
  return Vec3f(seen.corner + (seen.to_second * b + seen.to_third * c));
}

Vec3f sample(SampledTriangle& t, double u, double v) {
  if (!(t.solid_angle > least_solid_angle)) {
    const double outwards = std::sqrt(v);
    return on_triangle(t.seen, outwards * (1 - u), outwards * u);
  }
  if (!t.is_ready) prepare(t);
  const Vec3d direction = direction_in(t.sphere, u, v);
  const double distance = dot(t.seen.corner, t.normal) / dot(direction, t.normal);
  const Vec3d offset = direction * distance - t.seen.corner;
  return on_triangle(t.seen, dot(offset, t.for_second), dot(offset, t.for_third));
}

void sample_all(std::vector<SampledTriangle>& triangles, bool is_by_area, SampleArrays to) {
  const double total = set_shares(triangles, is_by_area);
  replace_samples(to, [&](double u, double v) {
    const double share = u * total;
    const auto chosen = std::upper_bound(
        triangles.begin(), triangles.end() - 1, share,
        [](double sought, const SampledTriangle& t) { return sought < t.share_end; });
    const double begin = chosen == triangles.begin() ? 0 : std::prev(chosen)->share_end;
    return sample(*chosen, to_unit((share - begin) / (chosen->share_end - begin)), v);
  });
}

/// What is no polygon or mesh shines from its centre.
void sample_center(Vec3f center, Vec3f p, SampleArrays to) {
  replace_samples(to, [&](float, float) { return Vec3f(Vec3d(center) - Vec3d(p)); });
}

}  // namespace

void sample_polygon(const PolygonLight& light, Vec3f p, SampleArrays samples,
                    std::vector<SampledTriangle>& scratch) {
  gather(
      light, p, [](const SeenTriangle&) { return true; }, scratch);
  if (scratch.empty()) return sample_center(light.center, p, samples);
  sample_all(scratch, contains(light, p), samples);
}

void sample_mesh(const MeshLight& light, Vec3f p, SampleArrays samples,
                 std::vector<SampledTriangle>& scratch) {
  const bool is_inside = contains(light, p);
  gather(
      light, p, [&](const SeenTriangle& t) { return is_inside || t.volume() < 0; }, scratch);
  if (scratch.empty()) return sample_center(light.center, p, samples);
  sample_all(scratch, false, samples);
}

}  // namespace penumbra
