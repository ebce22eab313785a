// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/exposure.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

#include "penumbra/geometry/irradiance.h"
#include "penumbra/geometry/placed_shape.h"

namespace penumbra {
namespace {

constexpr std::size_t most_points = 2048;  // of each kind of shape
constexpr std::size_t enough_in_view = 16;

/// A point of a surface and its normal, on either side.
struct SurfaceSample {
  Vec3f p, n;
};

/// Points of one set's shapes: every so many of them, large ones more than once.
class Sampler {
 public:
  explicit Sampler(const Scene& scene) : scene_(scene) {}

  void add(const ShapeSet& shapes, const Transform* map) {
    each(shapes.spheres, [&](const Sphere& s) {
      for (const Vec3f n : {Vec3f(scene_.up), Vec3f{1, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, 1}})
        add(s.center + n * s.radius, n, s.surface, map);
    });
    each(shapes.cones,
         [&](const Cone& c) { add((c.base + c.apex) * 0.5f, Vec3f(scene_.up), c.surface, map); });
    each(shapes.rings, [&](const Ring& r) { add(r.center, r.normal, r.surface, map); });
    for (const Mesh& mesh : shapes.meshes) add(mesh, count_of(shapes.meshes), map);
  }

  const std::vector<SurfaceSample>& samples() const { return samples_; }

 private:
  template <class Shape, class F>
  static void each(const std::vector<Shape>& shapes, F&& f) {
    const std::size_t step = 1 + shapes.size() / (most_points / 4);
    for (std::size_t i = 0; i < shapes.size(); i += step) f(shapes[i]);
  }

  static std::size_t count_of(std::span<const Mesh> meshes) {
    std::size_t count = 0;
    for (const Mesh& mesh : meshes) count += mesh.triangles.size();
    return count;
  }

  /// `all`: triangles of all meshes. Few triangles are large ones: several points each, along a
  /// sequence that fills them evenly (Roberts' R2).
  void add(const Mesh& mesh, std::size_t all, const Transform* map) {
    const std::size_t step = 1 + all / most_points;
    const std::size_t points = std::clamp<std::size_t>(512 / std::max<std::size_t>(all, 1), 1, 32);
    for (std::size_t t = 0; t < mesh.triangles.size(); t += step) {
      const Triangle& corner = mesh.triangles[t];
      if (!std::all_of(corner.begin(), corner.end(),
                       [&](std::uint32_t i) { return i < mesh.positions.size(); }))
        continue;
      const Vec3f a = mesh.positions[corner[0]], u = mesh.positions[corner[1]] - a,
                  v = mesh.positions[corner[2]] - a;
      const std::uint32_t surface = t < mesh.surfaces.size() ? mesh.surfaces[t] : mesh.surface;
      for (std::size_t i = 0; i < points; ++i) {
        double x = std::fmod(0.5 + 0.7548776662466927 * double(i), 1.0),
               y = std::fmod(0.5 + 0.5698402909980532 * double(i), 1.0);
        if (points == 1) x = y = 1.0 / 3;
        if (x + y > 1) x = 1 - x, y = 1 - y;
        add(a + u * float(x) + v * float(y), cross(u, v), surface, map);
      }
    }
  }

  void add(Vec3f p, Vec3f n, std::uint32_t surface, const Transform* map) {
    if (surface < scene_.materials.size() && max_abs(scene_.materials[surface].emission) > 0)
      return;
    if (map) p = Vec3f(apply_point(*map, Vec3d(p))), n = Vec3f(apply_normal(*map, Vec3d(n)));
    n = normalize(n);
    if (is_finite(p) && n != Vec3f{}) samples_.push_back({p, n});
  }

  const Scene& scene_;
  std::vector<SurfaceSample> samples_;
};

std::vector<SurfaceSample> surface_samples(const Scene& scene) {
  Sampler sampler(scene);
  sampler.add(scene.shapes, nullptr);
  const std::size_t step = 1 + scene.shapes.instances.size() / 64;
  for (std::size_t i = 0; i < scene.shapes.instances.size(); i += step)
    if (const Instance& instance = scene.shapes.instances[i];
        instance.group < scene.shapes.groups.size())
      sampler.add(scene.shapes.groups[instance.group], &instance.placement);
  return sampler.samples();
}

/// Those that the camera has in its whole picture, if they are enough; a square one will do.
std::vector<SurfaceSample> in_view(const std::vector<SurfaceSample>& samples, Camera camera) {
  camera.window = {};
  const CameraFrame view = frame(camera, 1);
  std::vector<SurfaceSample> seen;
  for (const SurfaceSample& sample : samples) {
    const Vec3d to = Vec3d(sample.p) - view.origin;
    const double depth = dot(to, view.forward), reach = view.is_parallel ? 1 : depth;
    if (depth > 0 && std::abs(dot(to, view.right)) <= reach * length_squared(view.right) &&
        std::abs(dot(to, view.up)) <= reach * length_squared(view.up))
      seen.push_back(sample);
  }
  return seen.size() >= enough_in_view ? seen : samples;
}

double irradiance_at(const Scene& scene, Vec3f p, Vec3f n) {
  Vec3d sum;
  for (const Light& light : scene.lights) {
    const bool fades = light.falloff == Falloff::inverse_square;
    sum += Vec3d(light.intensity) * (irradiance(light.shape, p, n) * beam_factor(light, p) *
                                     (fades ? inverse_square_factor(light.shape, p) : 1));
  }
  return max_abs(sum);
}

}  // namespace

std::vector<double> irradiances(const Scene& scene) {
  std::vector<double> values;
  if (scene.lights.empty()) return values;
  std::vector<SurfaceSample> samples = surface_samples(scene);
  if (scene.camera) samples = in_view(samples, *scene.camera);
  // Some microseconds each: a crowd of lights is asked about at fewer points.
  constexpr std::size_t most_questions = 200'000, fewest_points = 32;
  const std::size_t points =
      std::clamp(most_questions / scene.lights.size(), fewest_points, most_points);
  const std::size_t step = 1 + samples.size() / points;
  for (std::size_t i = 0; i < samples.size(); i += step) {
    const auto [p, n] = samples[i];
    double value = 0;
    if (scene.camera) {
      const bool is_front = dot(scene.camera->from - Vec3d(p), Vec3d(n)) > 0;
      value = irradiance_at(scene, p, is_front ? n : -n);
    } else {
      value = std::max(irradiance_at(scene, p, n), irradiance_at(scene, p, -n));
    }
    if (value > 0 && std::isfinite(value)) values.push_back(value);
  }
  std::sort(values.begin(), values.end());
  return values;
}

double balance_lights(Scene& scene) {
  const std::vector<double> values = irradiances(scene);
  if (values.empty()) return 1;
  const double factor = 1 / values[values.size() * 9 / 10];
  if (!std::isfinite(factor) || !(factor > 0)) return 1;
  for (Light& light : scene.lights) light.intensity = scaled(light.intensity, factor);
  return factor;
}

}  // namespace penumbra
