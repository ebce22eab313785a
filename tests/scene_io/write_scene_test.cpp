// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/write_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "penumbra/scene/gallery.h"
#include "penumbra/scene_io/light_spec.h"
#include "tests/scene_io/text_source.h"

namespace penumbra {
namespace {

Scene read_back(const Scene& scene) {
  const Source source = source_of("t.nff", to_nff(scene));
  Warnings warnings("t.nff");
  Scene back = read_nff(source, warnings);
  EXPECT_TRUE(warnings.lines().empty());
  return back;
}

/// Floats with all bits in use, the same in every run.
class Noise {
 public:
  float operator()() {
    state_ = state_ * 1664525u + 1013904223u;
    return std::ldexp(static_cast<float>(state_ >> 8), -20) - 8;
  }
  float positive() { return std::abs((*this)()) + 0.001f; }
  Vec3f vector() {
    const float x = (*this)(), y = (*this)(), z = (*this)();
    return {x, y, z};
  }
  Color color() {
    const float r = positive() / 10, g = positive() / 10, b = positive() / 10;
    return {r, g, b};
  }

 private:
  std::uint32_t state_ = 7;
};

void expect_equal(const Material& a, const Material& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.diffuse, b.diffuse);
  EXPECT_EQ(a.highlight, b.highlight);
  EXPECT_EQ(a.shininess, b.shininess);
  EXPECT_EQ(a.mirror, b.mirror);
  EXPECT_EQ(a.transmission, b.transmission);
  EXPECT_EQ(a.refraction_index, b.refraction_index);
  EXPECT_EQ(a.emission, b.emission);
  EXPECT_EQ(a.casts_shadow, b.casts_shadow);
  EXPECT_EQ(a.emits_from_back, b.emits_from_back);
}

/// Corner by corner: vertices come back in the order of their use.
void expect_equal(const Mesh& a, const Mesh& b) {
  EXPECT_EQ(a.is_backdrop, b.is_backdrop);
  EXPECT_EQ(a.normals.empty(), b.normals.empty());
  ASSERT_EQ(a.triangles.size(), b.triangles.size());
  for (std::size_t t = 0; t < a.triangles.size(); ++t) {
    EXPECT_EQ(surface_of(a, t), surface_of(b, t));
    for (int corner = 0; corner < 3; ++corner) {
      const std::uint32_t i = a.triangles[t][corner], k = b.triangles[t][corner];
      EXPECT_EQ(a.positions[i], b.positions[k]);
      if (!a.normals.empty()) {
        EXPECT_EQ(a.normals[i], b.normals[k]);
      }
    }
  }
}

void expect_equal(const Scene& a, const Scene& b) {
  ASSERT_EQ(a.materials.size(), b.materials.size());
  for (std::size_t i = 0; i < a.materials.size(); ++i) expect_equal(a.materials[i], b.materials[i]);
  ASSERT_EQ(a.lights.size(), b.lights.size());
  for (std::size_t i = 0; i < a.lights.size(); ++i) {
    EXPECT_EQ(light_words(a.lights[i]), light_words(b.lights[i]));
    EXPECT_EQ(a.lights[i].intensity, b.lights[i].intensity);
    EXPECT_EQ(a.lights[i].falloff, b.lights[i].falloff);
    ASSERT_EQ(a.lights[i].beam.has_value(), b.lights[i].beam.has_value());
    if (!a.lights[i].beam) continue;
    EXPECT_EQ(a.lights[i].beam->axis, b.lights[i].beam->axis);
    EXPECT_EQ(a.lights[i].beam->cos_full, b.lights[i].beam->cos_full);
    EXPECT_EQ(a.lights[i].beam->cos_none, b.lights[i].beam->cos_none);
  }
  ASSERT_EQ(a.camera.has_value(), b.camera.has_value());
  if (a.camera) {
    EXPECT_EQ(a.camera->from, b.camera->from);
    EXPECT_EQ(a.camera->at, b.camera->at);
    EXPECT_EQ(a.camera->up, b.camera->up);
    EXPECT_EQ(a.camera->fov_deg, b.camera->fov_deg);
    EXPECT_EQ(a.camera->near, b.camera->near);
    EXPECT_EQ(a.camera->parallel_height, b.camera->parallel_height);
    EXPECT_EQ(a.camera->window.left, b.camera->window.left);
    EXPECT_EQ(a.camera->window.top, b.camera->window.top);
    EXPECT_EQ(a.camera->window.right, b.camera->window.right);
    EXPECT_EQ(a.camera->window.bottom, b.camera->window.bottom);
    EXPECT_EQ(a.camera->width, b.camera->width);
    EXPECT_EQ(a.camera->height, b.camera->height);
  }
  EXPECT_EQ(a.background, b.background);
  EXPECT_EQ(a.ambient, b.ambient);
  EXPECT_EQ(a.up, b.up);
  EXPECT_EQ(a.wants_ground, b.wants_ground);
  ASSERT_EQ(a.shapes.spheres.size(), b.shapes.spheres.size());
  for (std::size_t i = 0; i < a.shapes.spheres.size(); ++i) {
    EXPECT_EQ(a.shapes.spheres[i].center, b.shapes.spheres[i].center);
    EXPECT_EQ(a.shapes.spheres[i].radius, b.shapes.spheres[i].radius);
    EXPECT_EQ(a.shapes.spheres[i].surface, b.shapes.spheres[i].surface);
  }
  ASSERT_EQ(a.shapes.cones.size(), b.shapes.cones.size());
  for (std::size_t i = 0; i < a.shapes.cones.size(); ++i) {
    const Cone &c = a.shapes.cones[i], &d = b.shapes.cones[i];
    EXPECT_TRUE(c.base == d.base && c.apex == d.apex && c.base_radius == d.base_radius &&
                c.apex_radius == d.apex_radius && c.caps == d.caps && c.surface == d.surface);
  }
  ASSERT_EQ(a.shapes.rings.size(), b.shapes.rings.size());
  for (std::size_t i = 0; i < a.shapes.rings.size(); ++i) {
    const Ring &c = a.shapes.rings[i], &d = b.shapes.rings[i];
    EXPECT_TRUE(c.center == d.center && c.normal == d.normal && c.radius == d.radius &&
                c.inner_radius == d.inner_radius && c.surface == d.surface);
  }
  ASSERT_EQ(a.shapes.meshes.size(), b.shapes.meshes.size());
  for (std::size_t i = 0; i < a.shapes.meshes.size(); ++i)
    expect_equal(a.shapes.meshes[i], b.shapes.meshes[i]);
}

Mesh noisy_mesh(Noise& noise, bool has_normals) {
  Mesh mesh;
  for (int i = 0; i < 30; ++i) {
    mesh.positions.push_back(noise.vector());
    if (has_normals) mesh.normals.push_back(normalize(noise.vector()));
  }
  for (std::uint32_t i = 0; i + 2 < 30; ++i) {
    mesh.triangles.push_back({i, (i * 7 + 1) % 30, (i * 11 + 3) % 30});
    mesh.surfaces.push_back(i % 5);
  }
  return mesh;
}

Scene noisy_scene() {
  Noise noise;
  Scene scene;
  for (int i = 0; i < 20; ++i) {
    Material m{"material " + std::to_string(i),
               noise.color(),
               noise.color(),
               noise.positive(),
               noise.color(),
               noise.color(),
               noise.positive(),
               noise.color(),
               i % 4 != 0,
               -1,
               i % 3 != 0};
    scene.materials.push_back(m);
    scene.shapes.spheres.push_back({noise.vector(), noise.positive(), static_cast<unsigned>(i)});
    scene.shapes.cones.push_back({noise.vector(), noise.vector(), noise.positive(),
                                  i % 4 == 0 ? 0 : noise.positive(),
                                  i % 2 == 0 ? Caps::capped : Caps::open, 19u - i});
    const float inner = noise.positive();
    scene.shapes.rings.push_back({noise.vector(), normalize(noise.vector()),
                                  inner + noise.positive(), i % 2 == 0 ? 0 : inner, 3});
    scene.lights.push_back({PointLight{noise.vector()}, noise.color() * 3.0f, Falloff::none});
  }
  scene.lights.push_back(
      {BallLight{noise.vector(), noise.positive()}, noise.color(), Falloff::inverse_square});
  scene.lights.push_back({ParallelogramLight{noise.vector(), noise.vector(), noise.vector()}});
  scene.lights.push_back({DiskLight{noise.vector(), normalize(noise.vector()), noise.positive()}});
  scene.lights.push_back({LineLight{noise.vector(), noise.vector()}, noise.color()});
  scene.lights.push_back(parse_light(split_words("polygon 3 0 0 5 1 0.1 5 0 1 5.3 0.1 2 3")));
  scene.lights.push_back(parse_light(split_words("mesh 4 0 0 5 1 0.1 5 0 1 5.3 0.1 2 9")));
  scene.lights.push_back({SunLight{normalize(noise.vector()), 0.1f}, noise.color()});
  scene.shapes.meshes = {noisy_mesh(noise, false), noisy_mesh(noise, true),
                         noisy_mesh(noise, false), noisy_mesh(noise, true)};
  scene.shapes.meshes[2].is_backdrop = true;
  Mesh floor;
  floor.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  floor.triangles = {{0, 1, 2}, {0, 2, 3}};
  floor.surface = 4;
  floor.is_backdrop = true;
  scene.shapes.meshes.push_back(floor);
  for (std::size_t i = 0; i + 1 < scene.lights.size(); i += 2)  // the last is the sun
    scene.lights[i].beam = Beam{normalize(noise.vector()), 0.1f / static_cast<float>(i + 1),
                                i % 4 == 0 ? 0 : -0.123456f};
  scene.camera = Camera{.from = {1.0 / 3, -4, 1},
                        .at = {0, 0.1, 0},
                        .up = {0, 1e-9, 1},
                        .fov_deg = 44.4444444,
                        .parallel_height = 1.0 / 7,
                        .window = {-0.1, 1.0 / 3, 0.75, 0},
                        .near = 0.01,
                        .width = 320,
                        .height = 200};
  scene.background = noise.color();
  scene.ambient = noise.color();
  scene.up = normalize(Vec3d(1, 2, 3));
  return scene;
}

TEST(WriteNff, reads_back_to_the_same_bits) {
  const Scene scene = noisy_scene();
  expect_equal(scene, read_back(scene));
}

TEST(WriteNff, reads_back_the_built_in_scenes) {
  for (const char* name : {"balls:3", "rings", "rings:2", "cylinders", "molecule", "bust"}) {
    SCOPED_TRACE(name);
    const std::optional<Scene> scene = gallery_scene(name);
    ASSERT_TRUE(scene);
    expect_equal(*scene, read_back(*scene));
  }
}

TEST(WriteNff, reads_back_what_is_not_there) {
  Scene scene;
  scene.materials.emplace_back();
  scene.shapes.spheres.emplace_back();
  scene.wants_ground = true;
  expect_equal(scene, read_back(scene));
}

TEST(WriteNff, keeps_the_numbers_of_fill_lines) {
  const std::string text =
      "f 1 0.75 0.33 0.8 0 100000 0 1\nf 1 0.9 0.7 0.5 0.5 3.0827 0 1\nf 1 0 1 0.5 0.2 3.0827 0 0\n"
      "f 1 1 1 0.1 0.1 101.148 0.9 1.5\nf 0.9 0.1 0.1 0.99 0 100000 0 1\n";
  const Source source = source_of("t.nff", text);
  Warnings warnings("t.nff");
  const std::string written = to_nff(read_nff(source, warnings));
  for (const char* line : {"f 1 0.75 0.33 0.8 0 100000 0 1\n", "f 1 0.9 0.7 0.5 0.5 3.0827 0 1\n",
                           "f 1 0 1 0.5 0.2 3.0827 0 1\n", "f 1 1 1 0.1 0.1 101.148 0.9 1.5\n",
                           "f 0.9 0.1 0.1 0.99 0 100000 0 1\n"})
    EXPECT_TRUE(holds(written, line)) << line << written;
  EXPECT_FALSE(holds(written, "#! material")) << written;
}

TEST(WriteNff, whole_backdrops_stay_one_polygon) {
  const std::string written = to_nff(noisy_scene());
  EXPECT_TRUE(holds(written, "#! backdrop\np 4\n"));
  EXPECT_TRUE(holds(written, "#! mesh backdrop\n"));
}

TEST(WritePly, reads_back_to_the_same_mesh) {
  Noise noise;
  Scene scene;
  scene.materials.resize(5);
  for (int i = 0; i < 2; ++i) {
    Mesh mesh = noisy_mesh(noise, true);
    mesh.surfaces.clear();
    mesh.colors.assign(30, {0, 1, 0});
    mesh.uvs.assign(30, {0.25f, 0.5f});
    scene.shapes.meshes.push_back(mesh);
  }
  const auto path = std::filesystem::path(testing::TempDir()) / "write_ply_test.ply";
  write_scene(path, scene);
  Warnings warnings("");
  const Mesh back = read_ply(load(path), warnings).shapes.meshes.at(0);
  std::filesystem::remove(path);
  ASSERT_EQ(back.triangles.size(), 56u);
  EXPECT_EQ(back.positions[31], scene.shapes.meshes[1].positions[1]);
  EXPECT_EQ(back.normals[31], scene.shapes.meshes[1].normals[1]);
  EXPECT_EQ(back.colors[31], Color(0, 1, 0));
  EXPECT_EQ(back.uvs[31].v, 0.5f);
  EXPECT_EQ(back.triangles[28][0], scene.shapes.meshes[1].triangles[0][0] + 30);
}

TEST(WriteScene, refuses_what_it_cannot_write) {
  Scene scene;
  scene.shapes.spheres.emplace_back();
  EXPECT_TRUE(holds(error_of([&] { write_scene("a.ply", scene); }), "write .nff"));
  EXPECT_TRUE(holds(error_of([&] { write_scene("a.obj", scene); }), "use .nff or .ply"));
  EXPECT_NE(error_of([&] { write_scene("/nowhere/a.nff", scene); }), "");
}

}  // namespace
}  // namespace penumbra
