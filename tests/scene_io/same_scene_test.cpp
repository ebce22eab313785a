// SPDX-License-Identifier: MIT
// One scene written in several formats is one scene: the same shapes, lights and rays.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "penumbra/scene_io/light_spec.h"
#include "penumbra/scene_io/read_scene.h"
#include "tests/scene_io/temporary_folder.h"

namespace penumbra {
namespace {

Scene scene_of(const TemporaryFolder& folder, const std::string& name, const std::string& text) {
  return read_scene(folder.put(name, text)).scene;
}

void expect_near(Vec3d a, Vec3d b, const std::string& what) {
  EXPECT_LT(length(a - b), 1e-6 * (1 + length(b))) << what;
}

void expect_near(Vec3f a, Vec3f b, const std::string& what) {
  expect_near(Vec3d(a), Vec3d(b), what);
}

using Corners = std::array<Vec3f, 3>;

std::vector<Corners> triangles_of(const ShapeSet& shapes) {
  std::vector<Corners> all;
  for (const Mesh& mesh : shapes.meshes)
    for (const Triangle& t : mesh.triangles)
      all.push_back({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]});
  return all;
}

/// Whatever the order of meshes; each triangle must be seen from the same side.
void expect_same_triangles(const ShapeSet& a, const ShapeSet& b) {
  const std::vector<Corners> ours = triangles_of(a), theirs = triangles_of(b);
  ASSERT_EQ(ours.size(), theirs.size());
  for (const Corners& triangle : ours)
    EXPECT_TRUE(std::any_of(theirs.begin(), theirs.end(),
                            [&](Corners other) {
                              for (int turn = 0; turn < 3; ++turn) {
                                if (other == triangle) return true;
                                std::rotate(other.begin(), other.begin() + 1, other.end());
                              }
                              return false;
                            }))
        << triangle[0].x << " " << triangle[0].y << " " << triangle[0].z;
}

/// Readers put shapes in an order of their own.
template <typename Shape>
std::vector<Shape> sorted(std::vector<Shape> shapes, Vec3f Shape::*place) {
  std::sort(shapes.begin(), shapes.end(), [&](const Shape& a, const Shape& b) {
    const Vec3f p = a.*place, q = b.*place;
    return std::array{p.x, p.y, p.z} < std::array{q.x, q.y, q.z};
  });
  return shapes;
}

void expect_same_shapes(const Scene& a, const Scene& b) {
  const auto casts = [](const Scene& scene, std::uint32_t surface) {
    return scene.materials[surface].casts_shadow;
  };
  EXPECT_TRUE(a.shapes.instances.empty());
  ASSERT_EQ(a.shapes.spheres.size(), b.shapes.spheres.size());
  for (std::size_t i = 0; i < a.shapes.spheres.size(); ++i) {
    const Sphere x = sorted(a.shapes.spheres, &Sphere::center)[i],
                 y = sorted(b.shapes.spheres, &Sphere::center)[i];
    expect_near(x.center, y.center, "centre of a sphere");
    EXPECT_FLOAT_EQ(x.radius, y.radius);
    EXPECT_EQ(casts(a, x.surface), casts(b, y.surface));
  }
  ASSERT_EQ(a.shapes.cones.size(), b.shapes.cones.size());
  for (std::size_t i = 0; i < a.shapes.cones.size(); ++i) {
    const Cone &x = a.shapes.cones[i], &y = b.shapes.cones[i];
    expect_near(x.base, y.base, "base");
    expect_near(x.apex, y.apex, "apex");
    EXPECT_FLOAT_EQ(x.base_radius, y.base_radius);
    EXPECT_FLOAT_EQ(x.apex_radius, y.apex_radius);
    EXPECT_EQ(x.caps, y.caps);
  }
  ASSERT_EQ(a.shapes.rings.size(), b.shapes.rings.size());
  for (std::size_t i = 0; i < a.shapes.rings.size(); ++i) {
    const Ring x = sorted(a.shapes.rings, &Ring::center)[i],
               y = sorted(b.shapes.rings, &Ring::center)[i];
    expect_near(x.center, y.center, "centre of a ring");
    expect_near(x.normal, y.normal, "normal of a ring");
    EXPECT_FLOAT_EQ(x.radius, y.radius);
    EXPECT_FLOAT_EQ(x.inner_radius, y.inner_radius);
    EXPECT_EQ(casts(a, x.surface), casts(b, y.surface));
  }
  expect_same_triangles(a.shapes, b.shapes);
}

/// The light's shape in words, zeros without a sign.
std::string shape_words(const Light& light) {
  std::string words = light_words({light.shape});
  for (std::size_t at = 0; (at = words.find(" -0 ", at)) != std::string::npos;)
    words.erase(at + 1, 1);
  return words;
}

/// Intensities are those of `b` times `factor`: some formats leave exposure to whoever reads them.
void expect_same_lights(const Scene& a, const Scene& b, double factor) {
  ASSERT_EQ(a.lights.size(), b.lights.size());
  for (std::size_t i = 0; i < a.lights.size(); ++i) {
    const Light &x = a.lights[i], &y = b.lights[i];
    EXPECT_EQ(shape_words(x), shape_words(y));
    EXPECT_EQ(x.falloff, y.falloff);
    expect_near(Vec3d(x.intensity), Vec3d(y.intensity) * factor, light_words(y));
    ASSERT_EQ(x.beam.has_value(), y.beam.has_value()) << light_words(y);
    if (!x.beam) continue;
    expect_near(x.beam->axis, y.beam->axis, "axis of a beam");
    EXPECT_NEAR(x.beam->cos_full, y.beam->cos_full, 1e-6);
    EXPECT_NEAR(x.beam->cos_none, y.beam->cos_none, 1e-6);
  }
}

/// The same ray for every pixel.
void expect_same_view(const Scene& a, const Scene& b) {
  ASSERT_TRUE(a.camera && b.camera);
  EXPECT_EQ(a.camera->width, b.camera->width);
  EXPECT_EQ(a.camera->height, b.camera->height);
  const double aspect = static_cast<double>(a.camera->width) / a.camera->height;
  const CameraFrame x = frame(*a.camera, aspect), y = frame(*b.camera, aspect);
  EXPECT_EQ(x.is_parallel, y.is_parallel);
  for (const double right : {-1.0, 0.5, 1.0})
    for (const double down : {-1.0, 0.25, 1.0}) {
      const CameraLine p = line_at(x, right, down), q = line_at(y, right, down);
      expect_near(p.origin, q.origin, "a ray's origin");
      expect_near(normalize(p.direction), normalize(q.direction), "a ray's direction");
    }
}

/// What stands in light in all formats.
const std::string nff_shapes = R"(f 1 1 1 .5 0 0 0 1
s 1 2 0.5 0.5
c
-1 0 0 0.25
-1 0 2 0.25
#! ring 0 0 1
c
0 -2 0.125 1
0 -2 0.125 0.5
#! mesh
p 3
-4 -4 0
4 -4 0
4 4 0
p 3
-4 -4 0
4 4 0
-4 4 0
)";

/// What glows in all formats, seen, but no obstacle to its own light.
const std::string nff_glowing = R"(f 1 1 1 .5 0 0 0 1
#! material casts_shadow 0
s 2 -3 6 0.25
#! ring 0 0 -1
c
-2 0 5 0.5
-2 0 5 0
)";

TEST(SameScene, PbrtsIsThatOfNff) {
  const TemporaryFolder folder;
  const Scene pbrt = scene_of(folder, "t.pbrt", R"(
Film "rgb" "integer xresolution" 320 "integer yresolution" 240
Scale -1 1 1  # pbrt's camera is left-handed
LookAt 3 -8 4  0 0 1  0 0 1
Camera "perspective" "float fov" 40
WorldBegin
AttributeBegin
  Translate 1 2 0  Translate 0 0 0.5
  Shape "sphere" "float radius" 0.5
AttributeEnd
AttributeBegin
  Translate -1 0 1  Rotate 90 0 0 1
  Shape "cylinder" "float radius" 0.25
AttributeEnd
AttributeBegin
  Translate 0 -2 0  Scale 2 2 2
  Shape "disk" "float radius" 0.5 "float innerradius" 0.25 "float height" 0.0625
AttributeEnd
ObjectBegin "floor"
  Shape "trianglemesh" "point3 P" [-1 -1 0  1 -1 0  1 1 0  -1 1 0] "integer indices" [0 1 2 0 2 3]
ObjectEnd
AttributeBegin
  Scale 4 4 4
  ObjectInstance "floor"
AttributeEnd
AttributeBegin
  AreaLightSource "diffuse" "rgb L" [16 12 8]
  Translate 2 -3 6
  Shape "sphere" "float radius" 0.25
AttributeEnd
AttributeBegin
  AreaLightSource "diffuse" "rgb L" [4 4 4] "float scale" 2
  Translate -2 0 5
  ReverseOrientation
  Shape "disk" "float radius" 0.5
AttributeEnd
LightSource "point" "point3 from" [0 -6 7] "rgb I" [10 20 30]
LightSource "spot" "point3 from" [5 0 5] "point3 to" [5 0 0] "rgb I" [8 8 8]
  "float coneangle" 40 "float conedeltaangle" 10
LightSource "distant" "point3 from" [0 0 4] "point3 to" [0 3 0] "rgb L" [0.5 0.5 0.5]
)");
  // Intensities: radiance times projected area; a white surface shows 1 / pi of irradiance.
  const Scene nff = scene_of(folder, "t.nff", R"(v
from 3 -8 4
at 0 0 1
up 0 0 1
angle 40
hither 0
resolution 320 240
#! light sphere 2 -3 6 0.25 1 0.75 0.5
#! falloff inverse_square
#! light disk -2 0 5 0 0 -1 0.5 2 2 2 beam 0 0 -1 90 90
#! falloff inverse_square
#! light point 0 -6 7 3.18309886 6.36619772 9.54929659
#! falloff inverse_square
#! light point 5 0 5 2.54647909 2.54647909 2.54647909 beam 0 0 -1 30 40
#! falloff inverse_square
#! light sun 0 -0.6 0.8 0 0.159154943 0.159154943 0.159154943
)" + nff_shapes + nff_glowing);
  expect_same_shapes(pbrt, nff);
  expect_same_lights(pbrt, nff, 1);
  expect_same_view(pbrt, nff);
}

TEST(SameScene, RadiancesIsThatOfNff) {
  const TemporaryFolder folder;
  folder.put("floor.rad",
             "stone polygon a 0 0 9 -1 -1 0 1 -1 0 1 1 0\n"
             "stone polygon b 0 0 9 -1 -1 0 1 1 0 -1 1 0\n");
  folder.put("room.rad", R"(void plastic stone 0 0 5 .5 .5 .5 0 0
stone sphere ball 0 0 4 1 2 0.5 0.5
stone cylinder wall 0 0 7 -1 0 0 -1 0 2 0.25
stone ring plate 0 0 8 0 -2 0.125 0 0 3 1 0.5
!xform -s 4 floor.rad
void light warm 0 0 3 16 12 8
warm sphere lamp 0 0 4 2 -3 6 0.25
void light white 0 0 3 8 8 8
white ring lamp 0 0 8 -2 0 5 0 0 -1 0 0.5
void spotlight spot 0 0 7 8 8 8 60 0 0 -1
spot ring lamp 0 0 8 5 0 5 0 0 -1 0 0.5
void light solar 0 0 3 1000 1000 1000
solar source sun 0 0 4 0 -3 4 2
)");
  const Scene radiance = scene_of(folder, "room.rif",
                                  "scene= room.rad\n"
                                  "view= -vtv -vp 3 -8 4 -vd -3 8 -3 -vu 0 0 1 -vh 40 -vv 40\n");
  // Of the sun: radiance times pi times the squared sine of half its angle.
  const Scene nff = scene_of(folder, "t.nff", R"(v
from 3 -8 4
at 0 0 1
up 0 0 1
angle 40
hither 0
resolution 512 512
#! light sphere 2 -3 6 0.25 3.14159265 2.35619449 1.57079633
#! falloff inverse_square
#! light disk -2 0 5 0 0 -1 0.5 6.28318531 6.28318531 6.28318531 beam 0 0 -1 90 90
#! falloff inverse_square
#! light disk 5 0 5 0 0 -1 0.5 6.28318531 6.28318531 6.28318531 beam 0 0 -1 30 30
#! falloff inverse_square
#! light sun 0 -0.6 0.8 2 0.956886681 0.956886681 0.956886681
)" + nff_shapes + nff_glowing + "#! ring 0 0 -1\nc\n5 0 5 0.5\n5 0 5 0\n");
  expect_same_shapes(radiance, nff);
  ASSERT_FALSE(radiance.lights.empty());
  expect_same_lights(radiance, nff,
                     static_cast<double>(radiance.lights[0].intensity.x) /
                         static_cast<double>(nff.lights[0].intensity.x));
  expect_same_view(radiance, nff);
}

}  // namespace
}  // namespace penumbra
