// SPDX-License-Identifier: MIT
// What glows in Radiance scenes, as lights.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <variant>

#include "tests/scene_io/radiance_scene.h"

namespace penumbra {
namespace {

constexpr double pi = std::numbers::pi;

/// How many times brighter the first light is than the second.
double ratio(const Scene& scene) {
  return static_cast<double>(scene.lights.at(0).intensity.x) /
         static_cast<double>(scene.lights.at(1).intensity.x);
}

const std::string lamp = "void light lamp 0 0 3 2 2 2\n";

TEST(RadianceLights, balls_and_disks_are_exact) {
  const RadianceRead read = read_rad(lamp +
                                     "lamp sphere a 0 0 4 1 2 3 0.5\n"
                                     "lamp ring b 0 0 8 0 0 5 0 0 -3 0 0.25\n");
  ASSERT_EQ(read.scene.lights.size(), 2u);
  const auto& ball = std::get<BallLight>(read.scene.lights[0].shape);
  EXPECT_EQ(ball.center, Vec3f(1, 2, 3));
  EXPECT_EQ(ball.radius, 0.5f);
  EXPECT_FALSE(read.scene.lights[0].beam);
  const auto& disk = std::get<DiskLight>(read.scene.lights[1].shape);
  EXPECT_EQ(disk.normal, Vec3f(0, 0, -1));
  ASSERT_TRUE(read.scene.lights[1].beam);  // its front alone
  EXPECT_EQ(read.scene.lights[1].beam->axis, Vec3f(0, 0, -1));
  EXPECT_EQ(read.scene.lights[1].beam->cos_none, 0);
  // Radiant intensity is radiance times the projected area.
  EXPECT_NEAR(ratio(read.scene), 0.5 * 0.5 / (0.25 * 0.25), 1e-5);
  for (const Light& light : read.scene.lights) EXPECT_EQ(light.falloff, Falloff::inverse_square);
  // Both are seen, and do not stand in their own light.
  const ShapeSet shapes = all_placed(read.scene);
  const Material& seen = read.scene.materials[shapes.spheres.at(0).surface];
  EXPECT_FALSE(seen.casts_shadow);
  EXPECT_GT(seen.emission.x, 0);
  EXPECT_EQ(shapes.rings.at(0).surface, shapes.spheres[0].surface);
}

TEST(RadianceLights, a_polygon_shines_from_its_front) {
  const RadianceRead read = read_rad(lamp + "lamp polygon a 0 0 12 0 0 5 0 1 5 1 1 5 1 0 5\n");
  ASSERT_EQ(read.scene.lights.size(), 1u);
  const Mesh mesh = all_placed(read.scene).meshes.at(0);
  const Material& material = read.scene.materials[surface_of(mesh, 0)];
  EXPECT_GT(material.emission.x, 0);
  EXPECT_FALSE(material.emits_from_back);
  const Triangle t = mesh.triangles[0];
  EXPECT_LT(cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                  mesh.positions[t[2]] - mesh.positions[t[0]])
                .z,
            0);
}

TEST(RadianceLights, luminaires_say_that_their_distribution_is_not_read) {
  const RadianceRead read = read_rad(
      "void brightdata dist 4 flatcorr a.dat source.cal src_theta 0 1 0.5\n"
      "dist light luminaire 0 0 3 1 1 1\nluminaire ring a 0 0 8 0 0 5 0 0 -1 0 1\n");
  EXPECT_EQ(read.scene.lights.size(), 1u);
  EXPECT_TRUE(read.warns_of("brightdata is not read: its lights are as bright in all directions"));
}

TEST(RadianceLights, the_sun_has_its_angle) {
  const RadianceRead read = read_rad(
      "void light solar 0 0 3 1000 1000 1000\nsolar source sun 0 0 4 0 -3 4 0.5\n"
      "solar source moon 0 0 4 0 0 1 1\n");
  ASSERT_EQ(read.scene.lights.size(), 2u);
  const auto& sun = std::get<SunLight>(read.scene.lights[0].shape);
  EXPECT_NEAR(sun.direction.y, -0.6, 1e-6);
  EXPECT_NEAR(sun.half_angle_rad, 0.25 * pi / 180, 1e-7);
  EXPECT_NEAR(ratio(read.scene), 0.25, 1e-3);  // of the solid angles
  EXPECT_EQ(read.scene.background, Color());
}

TEST(RadianceLights, the_sky_of_gendaylit_counts_by_its_mean) {
  // 1 + cos² of the angle from the sun, which is in the zenith: 1.5 in the mean.
  const RadianceRead read = read_rad(
      "void light solar 0 0 3 1e6 1e6 1e6\nsolar source sun 0 0 4 0 0 1 0.5\n"
      "void brightfunc skyfunc 2 skybright perezlum.cal 0 10 20 10 0 0 0 0 1 0 0 1\n"
      "skyfunc glow white 0 0 4 1 1 1 0\nwhite source both 0 0 4 0 0 1 360\n");
  const double half = 0.25 * pi / 180, sun = 1e6 * pi * std::sin(half) * std::sin(half);
  EXPECT_NEAR(read.scene.ambient.x, 0.5 * (20 * 1.5 + 10) * pi / sun, 1e-4);
}

TEST(RadianceLights, the_sky_is_background_and_ambient_in_the_suns_measure) {
  const RadianceRead read = read_rad(
      "void light solar 0 0 3 1e6 1e6 1e6\nsolar source sun 0 0 4 0 0 1 0.5\n"
      "void brightfunc skyfunc 2 skybr skybright.cal 0 7 1 20 10 .5 0 0 1\n"
      "skyfunc glow blue 0 0 4 .5 .5 1 0\nblue source sky 0 0 4 0 0 1 180\n"
      "skyfunc glow brown 0 0 4 .5 .25 .25 0\nbrown source ground 0 0 4 0 0 -1 180\n");
  ASSERT_EQ(read.scene.lights.size(), 1u);
  EXPECT_NEAR(read.scene.lights[0].intensity.x, 1, 1e-5);
  // A white surface under a sky of radiance L shows L; the sun's irradiance, over pi, shows as 1.
  const double half = 0.25 * pi / 180, sun = 1e6 * pi * std::sin(half) * std::sin(half);
  ASSERT_TRUE(read.scene.background);
  EXPECT_NEAR(read.scene.background->z, 20 * pi / sun, 1e-4);
  EXPECT_NEAR(read.scene.background->x, 10 * pi / sun, 1e-4);
  // skybright.cal gives the ground its own brightness, 10 here.
  EXPECT_NEAR(read.scene.ambient.z, 0.5 * (20 + 2.5) * pi / sun, 1e-4);
  EXPECT_TRUE(read.warns_of("the sky is light from everywhere alike"));
}

TEST(RadianceLights, a_glow_lights_by_its_radius) {
  const std::string surface = "g sphere s 0 0 4 0 0 0 1\n";
  for (const char* radius : {"0", "-1"}) {
    const RadianceRead read =
        read_rad("void glow g 0 0 4 1 1 1 " + std::string(radius) + "\n" + surface);
    EXPECT_TRUE(read.scene.lights.empty());
    const Material& m = read.scene.materials[all_placed(read.scene).spheres.at(0).surface];
    EXPECT_GT(m.emission.x, 0);
    EXPECT_TRUE(m.casts_shadow);
  }
  EXPECT_EQ(read_rad("void glow g 0 0 4 1 1 1 50\n" + surface).scene.lights.size(), 1u);
}

TEST(RadianceLights, a_spotlight_has_its_cone) {
  const std::string spot = "void spotlight spot 0 0 7 5 5 5 60 0 0 -2\n";
  const RadianceRead read =
      read_rad(spot +
               "spot ring a 0 0 8 0 0 5 0 0 -1 0 0.1\n"
               "spot polygon b 0 0 12 0 0 5 0 1 5 1 1 5 1 0 5\nspot sphere c 0 0 4 0 0 9 .1\n");
  ASSERT_EQ(read.scene.lights.size(), 3u);
  for (const Light& light : read.scene.lights) {
    ASSERT_TRUE(light.beam);
    EXPECT_EQ(light.beam->axis, Vec3f(0, 0, -1));
    EXPECT_NEAR(light.beam->cos_none, std::cos(pi / 6), 1e-6);
  }
  EXPECT_TRUE(read_rad(spot + "spot cone a 0 0 8 0 0 0 0 0 1 1 0\n").warns_of("without its cone"));
}

TEST(RadianceLights, an_illum_is_not_seen) {
  const std::string square = "polygon a 0 0 12 0 0 5 0 1 5 1 1 5 1 0 5\n";
  const RadianceRead bare = read_rad("void illum window 0 0 3 1 1 1\nwindow " + square);
  ASSERT_EQ(bare.scene.lights.size(), 1u);
  EXPECT_EQ(std::get<PolygonLight>(bare.scene.lights[0].shape).corners.size(), 4u);
  EXPECT_TRUE(all_placed(bare.scene).meshes.empty());
  const RadianceRead glazed = read_rad(
      "void glass pane 0 0 3 .9 .9 .9\nvoid illum window 1 pane 0 3 1 1 1\nwindow " + square);
  EXPECT_EQ(glazed.scene.lights.size(), 1u);
  const Material& pane = glazed.scene.materials[all_placed(glazed.scene).meshes.at(0).surface];
  EXPECT_EQ(pane.name, "pane");
  EXPECT_FALSE(pane.casts_shadow);
}

TEST(RadianceLights, round_ones_are_closed_meshes_that_look_outwards) {
  const RadianceRead read = read_rad(lamp + "lamp cylinder tube 0 0 7 -1 0 0 1 0 0 .25\n");
  const Mesh mesh = all_placed(read.scene).meshes.at(0);
  const MeshTopology found = topology(mesh);
  EXPECT_EQ(found.boundary_edges, 0u);
  EXPECT_NEAR(six_volume(mesh) / 6, pi / 16 * 2, 0.01);
  const RadianceRead ring = read_rad(lamp + "lamp ring r 0 0 8 0 0 0 0 0 1 1 2\n");
  EXPECT_NEAR(area(all_placed(ring.scene).meshes.at(0)), 3 * pi, 0.15);
}

TEST(RadianceLights, lights_in_placed_files_stand_where_they_are_placed) {
  const TemporaryFolder folder;
  folder.put("lamp.rad", lamp +
                             "void spotlight s 0 0 7 1 1 1 40 0 0 -1\n"
                             "lamp sphere a 0 0 4 1 0 0 .5\ns ring b 0 0 8 0 0 0 0 0 -1 0 1\n");
  const RadianceRead read =
      read_radiance_source(load(folder.put("t.rad",
                                           "void sphere o 0 0 4 0 0 0 1\n"
                                           "!xform -s 2 -ry 90 -a 2 -t 0 10 0 lamp.rad\n")));
  ASSERT_EQ(read.scene.lights.size(), 4u);
  const auto& ball = std::get<BallLight>(read.scene.lights[2].shape);
  EXPECT_EQ(ball.center, Vec3f(0, 10, -2));
  EXPECT_EQ(ball.radius, 1);
  ASSERT_TRUE(read.scene.lights[3].beam);
  EXPECT_NEAR(read.scene.lights[3].beam->axis.x, -1, 1e-6);
  EXPECT_TRUE(read.scene.shapes.instances.empty());
}

}  // namespace
}  // namespace penumbra
