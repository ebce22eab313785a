// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <string>
#include <vector>

#include "penumbra/scene_io/exposure.h"
#include "penumbra/scene_io/gltf_materials.h"
#include "penumbra/scene_io/gltf_uri.h"
#include "tests/scene_io/gltf_read.h"
#include "tests/scene_io/temporary_folder.h"
#include "tests/scene_io/text_source.h"

namespace penumbra {
namespace {

TEST(ReadGltf, a_triangle) {
  const Scene scene = read(GltfText{}).scene;
  ASSERT_EQ(scene.shapes.meshes.size(), 1u);
  EXPECT_EQ(scene.shapes.meshes[0].triangles.size(), 1u);
  EXPECT_EQ(scene.shapes.meshes[0].positions[1], (Vec3f{1, 0, 0}));
  EXPECT_TRUE((scene.up == Vec3d{0, 1, 0}));
  EXPECT_TRUE(scene.wants_ground);
}

TEST(ReadGltf, binary_file_is_the_same) {
  const Scene text = read(GltfText{}).scene;
  const Scene binary = read_valid(source_of("t.glb", GltfText{}.glb())).scene;
  EXPECT_EQ(text.shapes.meshes[0].positions, binary.shapes.meshes[0].positions);
  EXPECT_EQ(text.shapes.meshes[0].triangles, binary.shapes.meshes[0].triangles);
}

TEST(ReadGltf, index_types_and_modes) {
  for (const char* indices : {R"("bufferView":1,"componentType":5121,"count":3)",
                              R"("bufferView":2,"componentType":5123,"count":3)",
                              R"("bufferView":3,"componentType":5125,"count":3)"}) {
    GltfText text;
    text.indices = indices;
    EXPECT_EQ(read(text).scene.shapes.meshes[0].triangles[0], (Triangle{0, 1, 2}));
  }
  GltfText strip;
  strip.indices = R"("bufferView":4,"componentType":5121,"count":4)";
  strip.primitive = R"(,"mode":5)";
  const Scene stripped = read(strip).scene;
  EXPECT_EQ(stripped.shapes.meshes[0].triangles[0], (Triangle{0, 1, 2}));
  EXPECT_EQ(stripped.shapes.meshes[0].triangles[1], (Triangle{1, 3, 2}));
  strip.primitive = R"(,"mode":6)";
  EXPECT_EQ(read(strip).scene.shapes.meshes[0].triangles[1], (Triangle{0, 2, 3}));
}

TEST(ReadGltf, deep_hierarchies_are_read_and_cycles_refused) {
  GltfText text;
  text.nodes = "{\"children\":[1]}";
  for (int i = 2; i < 20000; ++i) text.nodes += ",{\"children\":[" + std::to_string(i) + "]}";
  text.nodes += ",{\"mesh\":0}";
  EXPECT_EQ(read(text).scene.shapes.meshes.size(), 1u);
  text.nodes = R"({"children":[1]},{"mesh":0,"children":[0]})";
  EXPECT_TRUE(holds(error_in(text), "is its own ancestor"));
}

TEST(ReadGltf, sparse_accessors_replace_elements) {
  GltfText text;
  text.positions =
      R"("bufferView":0,"componentType":5126,"type":"VEC3","count":4,"sparse":{"count":1,
      "indices":{"bufferView":1,"componentType":5121,"byteOffset":2},
      "values":{"bufferView":0,"byteOffset":36}})";
  EXPECT_EQ(read(text).scene.shapes.meshes[0].positions[2], (Vec3f{1, 1, 0}));
}

TEST(ReadGltf, base_colour_and_roughness) {
  GltfText text;
  text.primitive = R"(,"material":0)";
  text.rest = R"(,"materials":[{"pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,1,1],
    "metallicFactor":0}}])";
  const Material rough = read(text).scene.materials[0];
  EXPECT_EQ(rough.diffuse, (Color{0.5f, 0.25f, 1}));
  EXPECT_EQ(rough.mirror, Color{});
  EXPECT_LT(rough.highlight.x, 0.1f);
  text.rest = R"(,"materials":[{"pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,1,1],
    "metallicFactor":1,"roughnessFactor":0}}])";
  const Material mirror = read(text).scene.materials[0];
  EXPECT_EQ(mirror.mirror, (Color{0.5f, 0.25f, 1}));
  EXPECT_EQ(mirror.diffuse, Color{});
}

TEST(ReadGltf, transmission_refracts_with_a_volume) {
  GltfText text;
  text.primitive = R"(,"material":0)";
  const std::string begin =
      R"(,"materials":[{"pbrMetallicRoughness":{"metallicFactor":0,"roughnessFactor":0},
      "extensions":{"KHR_materials_transmission":{"transmissionFactor":1},
      "KHR_materials_ior":{"ior":1.33})";
  text.rest = begin + "}}]";
  const Material pane = read(text).scene.materials[0];
  EXPECT_EQ(pane.transmission, (Color{1, 1, 1}));
  EXPECT_EQ(pane.diffuse, Color{});
  EXPECT_EQ(pane.refraction_index, 1);
  text.rest = begin + R"(,"KHR_materials_volume":{"thicknessFactor":1}}}])";
  EXPECT_EQ(read(text).scene.materials[0].refraction_index, 1.33f);
}

/// The mesh of a file with these attributes: 2 is (0, 0) (0, 1) ..., 3 is (0, 0) (0, 1) (0, 1) ...
Mesh with_uv_sets(const std::string& attributes, const std::string& transform = "") {
  GltfText text;
  const std::string vec2 = R"(},{"componentType":5126,"type":"VEC2","count":4,"bufferView":0)";
  text.indices += vec2 + vec2 + R"(,"byteOffset":16)";
  text.primitive = R"(,"material":0)";
  text.rest = R"(,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0)" +
              transform + R"(}}}],"textures":[{"source":0}],
              "images":[{"uri":"data:image/png;base64,)" +
              tiny_png_base64() + R"("}])";
  std::string json = text.json();
  const std::string position = R"("POSITION":0)";
  json.replace(json.find(position), position.size(), position + attributes);
  return read_valid(source_of("t.gltf", json)).scene.shapes.meshes.at(0);
}

TEST(ReadGltf, the_second_set_of_texture_coordinates_is_that_of_lightmaps) {
  const Mesh one = with_uv_sets(R"(,"TEXCOORD_0":2)");
  EXPECT_EQ(one.uvs.size(), 4u);
  EXPECT_TRUE(one.lightmap_uvs.empty());
  EXPECT_EQ(one.name, "mesh 0");
  const Mesh two = with_uv_sets(R"(,"TEXCOORD_0":2,"TEXCOORD_1":3)");
  EXPECT_EQ(two.uvs[2].v, 1);  // 0 downwards
  ASSERT_EQ(two.lightmap_uvs.size(), 4u);
  EXPECT_EQ(two.lightmap_uvs[2].v, 0);  // 1 downwards
  EXPECT_EQ(two.lightmap_uvs[3].u, 1);
}

TEST(ReadGltf, lightmaps_do_not_follow_a_textures_transform) {
  const std::string doubled = R"(,"extensions":{"KHR_texture_transform":{"scale":[2,2]}})";
  const Mesh one = with_uv_sets(R"(,"TEXCOORD_0":3)", doubled);
  EXPECT_EQ(one.uvs[3].u, 2);
  ASSERT_EQ(one.lightmap_uvs.size(), 4u);
  EXPECT_EQ(one.lightmap_uvs[3].u, 1);
  const Mesh two = with_uv_sets(R"(,"TEXCOORD_0":3,"TEXCOORD_1":3)", doubled);
  EXPECT_EQ(two.lightmap_uvs[3].u, 1);
}

TEST(ReadGltf, texture_coordinates_grow_upwards_and_are_transformed) {
  EXPECT_FLOAT_EQ(to_uv({}, 0.25f, 0.25f).u, 0.25f);
  EXPECT_FLOAT_EQ(to_uv({}, 0.25f, 0.25f).v, 0.75f);
  // The specification's example: the lower left quarter of the image, turned by 90 degrees.
  const GltfUvUse use{0, 0, 1, std::numbers::pi / 2, 0.5, 0.5};
  EXPECT_NEAR(to_uv(use, 1, 0).u, 0, 1e-6);
  EXPECT_NEAR(to_uv(use, 1, 0).v, 0.5, 1e-6);
  EXPECT_NEAR(to_uv(use, 0, 1).u, 0.5, 1e-6);
  EXPECT_NEAR(to_uv(use, 0, 1).v, 0, 1e-6);
}

Material with_emission(const std::string& material, std::vector<std::string>* warnings = nullptr) {
  GltfText text;
  text.primitive = R"(,"material":0)";
  // A triangle of a pixel that is white.
  text.rest = R"(,"materials":[{"emissiveFactor":[1,0.5,0])" + material +
              R"(}],"textures":[{"source":0}],"images":[{"uri":"data:image/png;base64,)" +
              tiny_png_base64() + R"("}])";
  const GltfRead r = read(text);
  if (warnings != nullptr) *warnings = r.warnings;
  return r.scene.materials[0];
}

TEST(ReadGltf, emission_has_a_strength_a_side_and_a_texture) {
  const Material plain = with_emission("");
  EXPECT_EQ(plain.emission, (Color{1, 0.5f, 0}));
  EXPECT_FALSE(plain.emits_from_back);
  EXPECT_TRUE(with_emission(R"(,"doubleSided":true)").emits_from_back);
  const std::string strong =
      R"(,"extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":8}})";
  EXPECT_EQ(with_emission(strong).emission, (Color{8, 4, 0}));
  const Color textured = with_emission(R"(,"emissiveTexture":{"index":0})").emission;
  const Texture picture = *decode_texture(*decode_data_uri("data:;base64," + tiny_png_base64()),
                                          ImageCoding::srgb, 1000);
  EXPECT_FLOAT_EQ(textured.x, picture.pixels[0].x);
  EXPECT_FLOAT_EQ(textured.y, picture.pixels[0].y * 0.5f);
}

TEST(ReadGltf, blended_surfaces_let_through_what_alpha_leaves) {
  GltfText text;
  text.primitive = R"(,"material":0)";
  text.rest = R"(,"materials":[{"alphaMode":"BLEND","pbrMetallicRoughness":{"metallicFactor":0,
    "baseColorFactor":[1,0.5,0.5,0.25]}}])";
  const GltfRead r = read(text);
  EXPECT_TRUE(r.warnings.empty());
  EXPECT_EQ(r.scene.materials[0].transmission, (Color{0.75f, 0.75f, 0.75f}));
  EXPECT_EQ(r.scene.materials[0].diffuse, (Color{0.25f, 0.125f, 0.125f}));
  EXPECT_EQ(r.scene.materials[0].refraction_index, 1);
}

TEST(ReadGltf, required_extensions_that_move_nothing_are_a_warning_and_others_refused) {
  GltfText text;
  text.rest = R"(,"extensionsRequired":["KHR_mesh_quantization","KHR_materials_ior"])";
  EXPECT_TRUE(read(text).warnings.empty());
  text.rest = R"(,"extensionsRequired":["KHR_materials_sparkle"])";
  EXPECT_TRUE(holds(read(text).warnings.at(0), "KHR_materials_sparkle is not read"));
  text.rest = R"(,"extensionsRequired":["ACME_curved_meshes"])";
  EXPECT_TRUE(holds(error_in(text), "requires the extension 'ACME_curved_meshes'"));
  text.rest = R"(,"extensionsRequired":["EXT_meshopt_compression"])";
  EXPECT_TRUE(holds(error_in(text), "gltf-transform copy"));
  text.rest = R"(,"extensionsRequired":[5])";
  EXPECT_TRUE(holds(error_in(text), "not a list of names"));
}

TEST(ReadGltf, an_array_is_not_read_a_thousand_times) {
  GltfText text;
  const std::string many(120'000, '\0');
  text.buffer_uri = "data:application/octet-stream;base64," + base64(GltfText::bytes() + many);
  text.positions = R"("bufferView":6,"componentType":5126,"type":"VEC3","count":10000)";
  text.more_views = R"(,{"buffer":0,"byteOffset":76,"byteLength":120000})";
  for (int i = 0; i < 3; ++i) text.primitive += R"(},{"attributes":{"POSITION":0},"indices":1)";
  EXPECT_NO_THROW(parsed(text));
  for (int i = 0; i < 1500; ++i) text.primitive += R"(},{"attributes":{"POSITION":0},"indices":1)";
  EXPECT_TRUE(holds(error_in(text), "far more numbers"));
}

TEST(ReadGltf, embedded_images_are_textures) {
  GltfText text;
  text.primitive = R"(,"material":0)";
  text.rest = R"(,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],
    "textures":[{"source":0}],"images":[{"uri":"data:image/png;base64,)" +
              tiny_png_base64() + R"("}])";
  const Scene scene = read(text).scene;
  ASSERT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(scene.textures[0].width, 1u);
  EXPECT_EQ(scene.materials[0].texture, 0);
}

TEST(ReadGltf, files_beside_it_are_found_and_missing_ones_named) {
  TemporaryFolder folder;
  GltfText text;
  text.buffer_uri = "my%20data.bin";
  const auto path = folder.put("t.gltf", text.json());
  EXPECT_TRUE(
      holds(error_of([&] { read_valid(load(path)); }), "the buffer 'my%20data.bin' is missing"));
  folder.put("my data.bin", GltfText::bytes());
  EXPECT_EQ(read_valid(load(path)).scene.shapes.meshes.size(), 1u);
  folder.put("my data.bin", GltfText::bytes().substr(0, 20));
  EXPECT_TRUE(holds(error_of([&] { read_valid(load(path)); }), "buffer 0 claims"));

  text.buffer_uri.clear();
  text.primitive = R"(,"material":0)";
  text.rest = R"(,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],
    "textures":[{"source":0}],"images":[{"uri":"none.png"}])";
  const GltfRead result = read(text);
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_TRUE(holds(result.warnings[0], "the texture 'none.png' is missing"));
}

TEST(ReadGltf, a_buffer_s_file_is_loaded_once_whatever_it_is_called) {
  TemporaryFolder folder;
  folder.put("big.bin", std::string(1 << 24, ' '));
  GltfText text;
  std::string uris;
  for (int i = 0; i < 300; ++i) {
    uris += "./";
    text.more_buffers += R"(,{"byteLength":1,"uri":")" + uris + R"(big.bin"})";
  }
  const auto path = folder.put("t.gltf", text.json());
  EXPECT_EQ(read_valid(load(path)).scene.shapes.meshes.size(), 1u);  // or 5 GB would be read
}

TEST(ReadGltf, what_is_not_read_is_a_warning_or_an_error) {
  GltfText text;
  text.primitive = R"(,"material":0)";
  text.rest = R"(,"materials":[{"alphaMode":"BLEND"}])";
  EXPECT_TRUE(holds(read(text).warnings.at(0), "alpha of textures"));
  for (const char* required : {"", R"(,"extensionsRequired":["KHR_materials_unlit"])"}) {
    text.rest = R"(,"materials":[{"extensions":{"KHR_materials_unlit":{}}}])";
    text.rest += required;
    ASSERT_EQ(read(text).warnings.size(), 1u);
    EXPECT_TRUE(holds(read(text).warnings[0], "KHR_materials_unlit"));
  }
  text.rest = R"(,"extensionsRequired":["KHR_draco_mesh_compression"])";
  EXPECT_TRUE(holds(error_in(text), "compressed (KHR_draco_mesh_compression)"));
  text = {};
  text.primitive = R"(,"extensions":{"KHR_draco_mesh_compression":{}})";
  EXPECT_TRUE(holds(error_in(text), "KHR_draco_mesh_compression"));
  text.primitive = R"(,"mode":1)";
  EXPECT_TRUE(holds(error_in(text), "no triangles"));
}

TEST(ReadGltf, claims_beyond_the_file_are_refused) {
  const auto with_positions = [](const std::string& accessor) {
    GltfText text;
    text.positions = accessor;
    return error_in(text);
  };
  const std::string vec3 = R"("componentType":5126,"type":"VEC3",)";
  EXPECT_TRUE(holds(with_positions(vec3 + R"("bufferView":0,"count":1000000000)"), "larger than"));
  EXPECT_TRUE(holds(with_positions(vec3 + R"("bufferView":0,"count":5)"), "larger than"));
  EXPECT_TRUE(holds(with_positions(vec3 + R"("bufferView":0,"count":4,"byteOffset":4)"), "larger"));
  EXPECT_TRUE(holds(with_positions(vec3 + R"("count":1000000000)"), "without a buffer view"));
  EXPECT_TRUE(holds(with_positions(vec3 + R"("bufferView":99,"count":3)"), "number 99"));
  EXPECT_TRUE(holds(with_positions(vec3 + R"("bufferView":-1,"count":3)"), "whole number"));
  EXPECT_TRUE(holds(with_positions(vec3 + R"("bufferView":5,"count":3)"), "ends beyond"));
  GltfText text;
  text.indices = R"("bufferView":4,"componentType":5121,"count":4,"byteOffset":1)";
  EXPECT_TRUE(holds(error_in(text), "larger than"));
  text.indices = R"("bufferView":0,"componentType":5125,"count":6)";
  EXPECT_TRUE(holds(error_in(text), "a triangle uses vertex"));
}

TEST(ReadGltf, numbers_that_are_not_finite_give_their_byte) {
  GltfText text;
  const std::string file = text.glb();
  std::string broken = file;
  const std::size_t at = file.find(GltfText::bytes());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(broken.data() + at + 16, &nan, sizeof nan);
  EXPECT_TRUE(holds(error_of([&] { read_valid(source_of("t.glb", broken)); }),
                    "t.glb: byte " + std::to_string(at + 16) + ": a number that is not finite"));
}

TEST(ReadGltf, broken_files_name_line_or_byte) {
  EXPECT_TRUE(
      holds(error_of([] { read_valid(source_of("t.gltf", "{\n\"a\":\n}")); }), "t.gltf:3:"));
  EXPECT_TRUE(holds(error_of([] { read_valid(source_of("t.gltf", "")); }), "t.gltf:1:"));
  EXPECT_TRUE(holds(error_of([] { read_valid(source_of("t.gltf", "{}")); }), "no 'asset'"));
  const std::string file = GltfText{}.glb();
  EXPECT_TRUE(
      holds(error_of([&] { read_valid(source_of("t.glb", file.substr(0, file.size() - 8))); }),
            "a chunk of"));
  EXPECT_TRUE(
      holds(error_of([&] { read_valid(source_of("t.glb", file.substr(0, 14))); }), "byte 14"));
  // Deeper than any stack.
  const std::string deep = "{\"asset\":{\"version\":\"2.0\"},\"x\":" + std::string(1'000'000, '[');
  EXPECT_TRUE(holds(error_of([&] { read_valid(source_of("t.gltf", deep)); }), "broken JSON"));
  EXPECT_TRUE(holds(
      error_of([&] { read_valid(source_of("t.gltf", deep + std::string(1'000'000, ']') + "}")); }),
      "no triangles"));
}

TEST(GltfUri, base64_and_escapes) {
  EXPECT_EQ(decode_data_uri("data:;base64,aGVsbG8="), "hello");
  EXPECT_EQ(decode_data_uri("data:a/b;base64,aGVsbG8h"), "hello!");
  EXPECT_FALSE(decode_data_uri("data:;base64,a*b"));
  EXPECT_FALSE(decode_data_uri("data:,hello"));
  EXPECT_EQ(decode_uri("a%20b%zz%4"), "a b%zz%4");
}

}  // namespace
}  // namespace penumbra
