// SPDX-License-Identifier: MIT
// Instances in whole pictures: drawn as the shapes that they are, by every method.
#include <gtest/gtest.h>

#include "penumbra/geometry/placed_shape.h"
#include "penumbra/geometry/tessellation.h"
#include "penumbra/scene/complete_scene.h"
#include "penumbra/scene/gallery.h"
#include "penumbra/trace/prepare.h"
#include "penumbra/trace/render.h"
#include "tests/trace/same_bits.h"

namespace penumbra {
namespace {

constexpr Method proving[] = {Method::offset, Method::reduced, Method::umbra, Method::shaft};

RenderOptions picture() {
  RenderOptions options;
  options.width = options.height = 96;
  options.shadow_samples = 16;
  options.aovs = {Aov::visibility};
  return options;
}

Picture draw(const Scene& scene, Method method) {
  const Kernel kernel(scene.shapes, kernel_options(scene));
  return render(scene, prepare_shadows(scene, kernel, method), picture());
}

enum class Mirroring { some, none };

/// The rings, as a group of spheres and cylinders that stands three times, turned and in two sizes;
/// and smooth eggs of triangles, sheared and leaning, one of them mirrored. On a floor.
Scene placed_scene(Mirroring mirroring) {
  Scene scene = *gallery_scene("rings");
  ShapeSet rings;
  std::swap(rings.spheres, scene.shapes.spheres);
  std::swap(rings.cones, scene.shapes.cones);
  ShapeSet eggs;
  eggs.meshes.push_back(tessellated(Sphere{{0, 0, 0.5f}, 0.5f, rings.spheres[0].surface}, 40));
  scene.shapes.groups = {rings, eggs};
  const Box box = bounds(rings);
  const Vec3d middle(box.center());
  const double size = box.largest_extent(), mirror = mirroring == Mirroring::some ? -1 : 1;
  const auto about_middle = [&](Transform map, Vec3d shift) {
    map.offset = middle - apply_direction(map, middle) + shift * size;
    return map;
  };
  scene.shapes.instances = {
      {0, about_middle({}, {})},
      {0, about_middle({{0, 0.5, 0}, {-0.5, 0, 0}, {0, 0, 0.5}, {}}, {0.9, 0.2, 0})},
      {0, about_middle({{0.5, 0, 0}, {0, 0.3, 0.4}, {0, -0.4, 0.3}, {}}, {-0.9, 0.3, 0.1})}};
  const auto egg = [&](Vec3d x, Vec3d y, Vec3d z, Vec3d at) {
    scene.shapes.instances.push_back({1, {x * size, y * size, z * size, middle + at * size}});
  };
  egg({0.4, 0, 0}, {0, 0.4, 0}, {0.2, 0, 0.6}, {0.5, -0.5, 0.1});
  egg({0.2 * mirror, 0, 0}, {0, 0.3, 0}, {0, 0.1, 0.3}, {-0.5, -0.5, 0.1});
  return complete_scene(scene, {});
}

TEST(Instances, EveryMethodDrawsTheSamePicture) {
  const Scene scene = placed_scene(Mirroring::some);
  const Picture judge = draw(scene, Method::stochastic);
  for (const Method method : proving) {
    const Picture other = draw(scene, method);
    EXPECT_TRUE(same_bits(judge.image, other.image)) << "method " << static_cast<int>(method);
    EXPECT_GT(other.counters.shadow.lit, 0u);
    const bool proves_umbra = method == Method::umbra || method == Method::shaft;
    EXPECT_EQ(other.counters.shadow.umbra > 0, proves_umbra);
    EXPECT_LT(other.counters.shadow.rays, judge.counters.shadow.rays);
  }
}

/// Cylinders are placed with other roundings than those of a scene that has them as its own; so
/// only meshes and spheres give the very bits.
TEST(Instances, AreDrawnAsTheShapesThatTheyAre) {
  Scene scene = placed_scene(Mirroring::none);
  scene.shapes.groups[0].cones.clear();
  const Picture placed = draw(scene, Method::shaft);
  scene.shapes = flattened(scene.shapes);
  EXPECT_TRUE(same_bits(placed.image, draw(scene, Method::shaft).image));
}

/// A mirrored egg of smooth normals has its outside outside.
TEST(Instances, MirroredOnesAreShadedFromTheirOutside) {
  Scene scene = placed_scene(Mirroring::some);
  scene.shapes.groups[0].cones.clear();
  const Picture placed = draw(scene, Method::shaft);
  scene.shapes = flattened(scene.shapes);
  const Picture flat = draw(scene, Method::shaft);
  const Channel &a = *find_channel(placed.image, "G"), &b = *find_channel(flat.image, "G");
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i)
    different += std::abs(a.values[i] - b.values[i]) > 1e-4f;
  EXPECT_LT(different, 4u);  // where a sample passes an edge by a rounding
}

TEST(Instances, APixelSaysWhichOneItShows) {
  const Scene scene = placed_scene(Mirroring::none);
  const Kernel kernel(scene.shapes, kernel_options(scene));
  const ShadowScene shadows = prepare_shadows(scene, kernel, Method::shaft);
  bool is_named = false;
  for (std::uint32_t x = 0; x < 96 && !is_named; x += 8)
    is_named =
        explain_pixel(scene, shadows, picture(), x, 48).find("of instance") != std::string::npos;
  EXPECT_TRUE(is_named);
}

}  // namespace
}  // namespace penumbra
