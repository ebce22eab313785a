// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>

#include "tests/scene_io/temporary_folder.h"
#include "tests/scene_io/text_source.h"

namespace penumbra {
namespace {

struct Read {
  Scene scene;
  std::vector<std::string> warnings;
};

Read read(const Source& source) {
  Warnings warnings(source.path.string());
  Scene scene = read_obj(source, warnings);
  validate(scene);
  return {std::move(scene), warnings.lines()};
}

Read read(const std::string& text) { return read(source_of("t.obj", text)); }

std::string error_in(const std::string& text) {
  return error_of([&] { read(text); });
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(ReadObj, a_triangle) {
  const Scene scene = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").scene;
  ASSERT_EQ(scene.shapes.meshes.size(), 1u);
  EXPECT_EQ(scene.shapes.meshes[0].triangles[0], (Triangle{0, 1, 2}));
  EXPECT_TRUE((scene.up == Vec3d{0, 1, 0}));
  EXPECT_TRUE(scene.wants_ground);
  EXPECT_FALSE(scene.camera);
}

TEST(ReadObj, polygons_are_cut_concave_ones_too) {
  EXPECT_EQ(read(square + "f 1 2 3 4").scene.shapes.meshes[0].triangles.size(), 2u);
  const Scene arrow = read("v 0 0 0\nv 2 -1 0\nv 0.5 0 0\nv 2 1 0\nf 1 2 3 4\n").scene;
  double area = 0;
  for (const Triangle& t : arrow.shapes.meshes[0].triangles) {
    const auto& p = arrow.shapes.meshes[0].positions;
    area += 0.5 * length(cross(Vec3d(p[t[1]] - p[t[0]]), Vec3d(p[t[2]] - p[t[0]])));
  }
  EXPECT_NEAR(area, 2 - 1.5, 1e-6);
}

TEST(ReadObj, negative_indices_count_back_from_where_they_stand) {
  const Scene scene = read(square + "f -4 -3 -2\nv 9 9 9\nf -5 -3 -2\n").scene;
  const Mesh& mesh = scene.shapes.meshes[0];
  EXPECT_EQ(mesh.positions[mesh.triangles[1][0]], (Vec3f{0, 0, 0}));
  EXPECT_EQ(mesh.positions[mesh.triangles[1][1]], (Vec3f{1, 1, 0}));
}

TEST(ReadObj, vertices_are_shared_where_position_uv_and_normal_are_the_same) {
  const Scene scene = read(square +
                           "vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\nvn 0 1 0\n"
                           "f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/1 4/1/1\nf 1/1/2 2/2/2 4/1/2\n")
                          .scene;
  const Mesh& mesh = scene.shapes.meshes[0];
  EXPECT_EQ(mesh.positions.size(), 7u);
  EXPECT_EQ(mesh.normals.size(), 7u);
  EXPECT_EQ(mesh.uvs.size(), 7u);
  EXPECT_FLOAT_EQ(mesh.uvs[2].v, 1);
}

TEST(ReadObj, faces_without_normals_are_flat_unless_in_a_smoothing_group) {
  const std::string bent = square + "v 0 2 0.5\nv 1 2 0.5\n";
  EXPECT_TRUE(read(bent + "f 1 2 3 4\nf 4 3 6 5").scene.shapes.meshes[0].normals.empty());
  EXPECT_FALSE(read(bent + "s 1\nf 1 2 3 4\nf 4 3 6 5").scene.shapes.meshes[0].normals.empty());
  EXPECT_TRUE(read(bent + "s off\nf 1 2 3 4\nf 4 3 6 5").scene.shapes.meshes[0].normals.empty());
}

TEST(ReadObj, vertex_colours_are_srgb_and_stand_alone) {
  const Scene scene = read("v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0.5 0.5 0.5\nf 1 2 3\n").scene;
  const Mesh& mesh = scene.shapes.meshes[0];
  EXPECT_EQ(mesh.colors[0], (Color{1, 0, 0}));
  EXPECT_NEAR(mesh.colors[2].x, 0.214, 1e-3);
  EXPECT_EQ(scene.materials[mesh.surfaces[0]].diffuse, (Color{1, 1, 1}));
}

TEST(ReadObj, numbers_are_rounded_to_the_nearest_float) {
  const Scene scene =
      read("v 0.1 1e-45 1e-60\nv +1.00000005960464 16777217 0\nv 0 1 0\nf 1 2 3\n").scene;
  EXPECT_EQ(scene.shapes.meshes[0].positions[0], (Vec3f{0.1f, 1e-45f, 0}));
  EXPECT_EQ(scene.shapes.meshes[0].positions[1], (Vec3f{1.0f, 16777216.0f, 0}));
}

TEST(ReadObj, line_ends_comments_joints_and_a_byte_order_mark) {
  const Scene scene =
      read("\xEF\xBB\xBF# x\r\nv 0 0 0 # y\r\nv 1 0 \\\r\n 0\rv 0 1 0\rf 1 \\\n2 3").scene;
  EXPECT_EQ(scene.shapes.meshes[0].triangles.size(), 1u);
  EXPECT_TRUE(holds(error_in("v 0 0 0\nv 1 \\\n0 \\\n0\nf 1 2 3"), "t.obj:5: the face uses"));
}

TEST(ReadObj, errors_name_the_line) {
  EXPECT_TRUE(holds(error_in(square + "f 1 2 5"), "t.obj:5: the face uses vertex 5"));
  EXPECT_TRUE(holds(error_in(square + "f 1 2 0"), "t.obj:5: `0` is not an index"));
  EXPECT_TRUE(holds(error_in(square + "f 1 2 -5"), "t.obj:5: a face reaches back to -5"));
  EXPECT_TRUE(holds(error_in(square + "f 1/1 2/1 3/1"), "t.obj:5: the face uses texture"));
  EXPECT_TRUE(holds(error_in(square + "f 1//1 2//1 3//1"), "t.obj:5: the face uses normal 1"));
  EXPECT_TRUE(holds(error_in(square + "f 1 2"), "t.obj:5: a face with fewer than 3"));
  EXPECT_TRUE(holds(error_in(square + "f 1 2 3x"), "t.obj:5: `3x`"));
  EXPECT_TRUE(holds(error_in(square + "f 1 2 99999999999999999999"), "t.obj:5:"));
  EXPECT_TRUE(holds(error_in("v 0 nan 0"), "t.obj:1: `nan` is not a finite number"));
  EXPECT_TRUE(holds(error_in("v 0 inf 0"), "t.obj:1: `inf` is not a finite"));
  EXPECT_TRUE(holds(error_in("v 0 1e99 0"), "t.obj:1: `1e99` is not a finite"));
  EXPECT_TRUE(holds(error_in("v 0 0"), "t.obj:1: the line ends"));
  EXPECT_TRUE(holds(error_in("v 0 0 0\nglorp 3"), "t.obj:2: unknown keyword `glorp`"));
  EXPECT_TRUE(holds(error_in("v 0 0 0"), "t.obj: there are no faces"));
  EXPECT_TRUE(holds(error_in(""), "no faces"));
  EXPECT_TRUE(holds(error_in(std::string("\x7f\x45\x4c\x46\x00\x01", 6)), "unknown keyword"));
}

TEST(ReadObj, faces_may_come_before_vertices) {
  EXPECT_EQ(read("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").scene.shapes.meshes.size(), 1u);
}

TEST(ReadObj, missing_files_are_warnings) {
  const Read result = read("mtllib none.mtl\n" + square + "usemtl a\nf 1 2 3\nusemtl b\nf 1 2 4\n");
  ASSERT_EQ(result.warnings.size(), 2u);
  EXPECT_TRUE(holds(result.warnings[0], "t.obj:1: the material file 'none.mtl' is missing"));
  EXPECT_TRUE(holds(result.warnings[1], "t.obj:6: a material that no material file defines"));
  EXPECT_EQ(result.scene.materials[result.scene.shapes.meshes[0].surfaces[1]].name, "b");
}

TEST(ReadObj, lines_and_curves_are_a_warning) {
  const Read result = read(square + "l 1 2\nl 2 3\np 1\nf 1 2 3\n");
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_TRUE(holds(result.warnings[0], "t.obj:5: points, lines"));
}

Scene with_materials(const std::string& mtl, const std::string& use = "usemtl m\n") {
  TemporaryFolder folder;
  folder.put("my materials.mtl", mtl);
  const auto path = folder.put("t.obj", "mtllib my materials.mtl\n" + square + use + "f 1 2 3 4\n");
  return read(load(path)).scene;
}

Material material(const std::string& statements) {
  const Scene scene = with_materials("newmtl m\n" + statements);
  return scene.materials[scene.shapes.meshes[0].surfaces[0]];
}

TEST(ReadMtl, diffuse_highlight_and_emission) {
  const Material m = material("Kd 0.1 0.2 0.3\nKs 0.5\nNs 30\n");
  EXPECT_EQ(m.diffuse, (Color{0.1f, 0.2f, 0.3f}));
  EXPECT_EQ(m.highlight, (Color{0.5f, 0.5f, 0.5f}));
  EXPECT_EQ(m.shininess, 30);
  EXPECT_EQ(m.mirror, Color{});
  EXPECT_EQ(material("Ks 1 1 1\nNs 9\nillum 1").highlight, Color{});
  EXPECT_EQ(material("Ke 3 2 1").emission, (Color{3, 2, 1}));
}

TEST(ReadMtl, illum_three_to_eight_mirror) {
  EXPECT_EQ(material("Ks 0.9 0.8 0.7\nillum 3").mirror, (Color{0.9f, 0.8f, 0.7f}));
  EXPECT_EQ(material("Ks 0.9 0.8 0.7\nillum 5").mirror, (Color{0.9f, 0.8f, 0.7f}));
  EXPECT_EQ(material("Ks 0.9 0.8 0.7\nillum 2").mirror, Color{});
}

TEST(ReadMtl, what_is_dissolved_is_transmitted) {
  const Material thin = material("Kd 1 1 1\nd 0.25\nNi 1.5\n");
  EXPECT_EQ(thin.diffuse, (Color{0.25f, 0.25f, 0.25f}));
  EXPECT_EQ(thin.transmission, (Color{0.75f, 0.75f, 0.75f}));
  EXPECT_EQ(thin.refraction_index, 1);
  EXPECT_EQ(material("Tr 0.75").transmission, (Color{0.75f, 0.75f, 0.75f}));
  EXPECT_EQ(material("d 1\nTr 1").transmission, Color{});
}

TEST(ReadMtl, glass_refracts) {
  const Material glass = material("Kd 0 0 0\nKs 0.1 0.1 0.1\nTf 1 0.9 0.8\nNi 1.5\nillum 7\n");
  EXPECT_EQ(glass.transmission, (Color{1, 0.9f, 0.8f}));
  EXPECT_EQ(glass.refraction_index, 1.5f);
  EXPECT_EQ(material("Tf 1 1 1\nillum 2").transmission, Color{});
}

TEST(ReadMtl, errors_name_file_and_line) {
  EXPECT_TRUE(holds(error_of([] { material("Kd 1 x 1"); }), "my materials.mtl:2: `x` is not"));
  EXPECT_TRUE(holds(error_of([] { material("Ns nan"); }), "my materials.mtl:2: `nan`"));
  EXPECT_TRUE(holds(error_of([] { with_materials("Kd 1 1 1"); }), "my materials.mtl:1:"));
}

/// A 2 x 1 picture, red and green, as a TGA of 24 bits.
std::string tiny_tga() {
  std::string bytes(18, '\0');
  bytes[2] = 2, bytes[12] = 2, bytes[14] = 1, bytes[16] = 24;
  return bytes + std::string("\0\0\xff\0\xff\0", 6);
}

TEST(ReadMtl, textures_are_found_beside_the_file_and_read_once) {
  TemporaryFolder folder;
  folder.put("a picture.tga", tiny_tga());
  folder.put("m.mtl",
             "newmtl a\nKd 0 0 0\nmap_Kd -s 2 2 -clamp on a picture.tga\n"
             "newmtl b\nmap_Kd C:\\somewhere\\a picture.tga\nnewmtl c\nmap_Kd none.png\n");
  const Read result = read(
      load(folder.put("t.obj", "mtllib m.mtl\n" + square +
                                   "usemtl a\nf 1 2 3\nusemtl b\nf 1 3 4\nusemtl c\nf 1 2 4")));
  ASSERT_EQ(result.scene.textures.size(), 1u);
  EXPECT_EQ(result.scene.textures[0].pixels[0], (Color{1, 0, 0}));
  EXPECT_EQ(result.scene.textures[0].pixels[1], (Color{0, 1, 0}));
  const auto& materials = result.scene.materials;
  EXPECT_EQ(materials[1].texture, 0);
  EXPECT_EQ(materials[1].diffuse, (Color{1, 1, 1}));
  EXPECT_EQ(materials[2].texture, 0);
  EXPECT_EQ(materials[3].texture, -1);
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_TRUE(holds(result.warnings[0], "the texture 'none.png' is missing"));
}

TEST(ReadObj, a_glowing_parallelogram_lights_the_scene) {
  const Scene scene = with_materials("newmtl m\nKe 2 4 6\n");
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.lights[0].intensity, (Color{2, 4, 6}));  // of area 1
  EXPECT_FALSE(scene.materials[surface_of(scene.shapes.meshes[0], 0)].casts_shadow);
  EXPECT_FALSE(scene.wants_ground);
}

}  // namespace
}  // namespace penumbra
