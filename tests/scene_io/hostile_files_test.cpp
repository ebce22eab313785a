// SPDX-License-Identifier: MIT
// Files that were damaged by chance: a reader gives a scene or throws Error, and does so soon.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "penumbra/scene_io/gltf_uri.h"
#include "penumbra/scene_io/texture_io.h"
#include "penumbra/scene_io/write_scene.h"
#include "tests/scene_io/damage.h"
#include "tests/scene_io/gltf_text.h"
#include "tests/scene_io/text_source.h"

namespace penumbra {
namespace {

TEST(HostileFiles, nff) {
  const std::string sample =
      "b 0.1 0.2 0.3\nv\nfrom 1 -5 1\nat 0 0 0\nup 0 0 1\nangle 45\nhither 0.1\nresolution 64 64\n"
      "l 1 2 3\n#! light sphere 0 0 9 1\nf 1 0.5 0.2 0.5 0.5 3 0 1\n#! material emission 1 2 3\n"
      "s 0 0 0 1\n#! capped\nc 0 0 0 1 0 0 2 1\n#! backdrop\np 4 0 0 0 1 0 0 1 1 0 0 1 0\n"
      "#! mesh\np 5 4 0 0 0 3 0 1 0 0 0 -3 0 1 -4 0\npp 3 0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1\n"
      "#! ring 0 0 1\nc 0 0 0 1 0 0 0 2\n";
  EXPECT_GT(survivors("t.nff", {sample}, read_nff), 0);
}

TEST(HostileFiles, ply) {
  const std::string text =
      "ply\nformat ascii 1.0\ncomment c\nelement vertex 5\nproperty float x\nproperty float y\n"
      "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 2\n"
      "property list uchar int vertex_indices\nelement tristrips 1\nproperty list int int "
      "vertex_indices\nend_header\n0 0 0 0 0 1 1 2 3\n1 0 0 0 0 1 1 2 3\n1 1 0 0 0 1 1 2 3\n"
      "0 1 0 0 0 1 1 2 3\n.5 2 0 0 0 1 1 2 3\n3 0 1 2\n5 0 1 2 4 3\n6 0 1 2 3 -1 4\n";
  Scene scene;
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}};
  scene.shapes.meshes.push_back(mesh);
  const auto path = std::filesystem::path(testing::TempDir()) / "hostile.ply";
  write_scene(path, scene);
  const std::string little = load(path).bytes;
  std::filesystem::remove(path);
  std::string big = little;
  big.replace(big.find("little"), 6, "big");
  EXPECT_GT(survivors("t.ply", {text, little, big}, read_ply), 0);
}

TEST(HostileFiles, stl) {
  std::string text = "solid s\n";
  for (int i = 0; i < 4; ++i)
    text += "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 " +
            std::to_string(i) + "\nendloop\nendfacet\n";
  std::string binary(84 + 4 * 50, '\x3f');
  binary.replace(80, 4, std::string("\x04\0\0\0", 4));
  EXPECT_GT(survivors("t.stl", {text + "endsolid s\n", binary}, read_stl), 0);
}

TEST(HostileFiles, obj) {
  const std::string file =
      "mtllib a.mtl\nv 0 0 0\nv 1 0 0 0.1 0.2 0.3\nv 1 1 0\nv 0 1 0.5\nvt 0 0\nvt 1 1\n"
      "vn 0 0 1\nvn 0 1 0\ng a\nusemtl m\ns 1\nf 1/1/1 2/2/2 3/1/1 4/2/1\nf -4 -3 -2 -1\n"
      "s off\nf 1//1 2//2 4//1\nl 1 2\nf 1/1 2/2 3/1 4/2 1/1\n";
  EXPECT_GT(survivors("t.obj", {file}, read_obj), 100);
}

GltfText rich_gltf() {
  GltfText text;
  text.scene_nodes = "0,1,2";
  text.nodes = R"({"mesh":0,"scale":[1,2,3]},{"camera":0,"rotation":[0,0,0,1]},
    {"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],
    "extensions":{"KHR_lights_punctual":{"light":0}}})";
  text.positions +=
      R"(,"sparse":{"count":1,"indices":{"bufferView":1,"componentType":5121,"byteOffset":2},
      "values":{"bufferView":0,"byteOffset":36}})";
  text.primitive = R"(,"material":0,"mode":4)";
  text.rest = R"(,"cameras":[{"type":"perspective","perspective":{"yfov":0.5}}],
    "extensions":{"KHR_lights_punctual":{"lights":[{"type":"point","intensity":5}]}},
    "materials":[{"emissiveFactor":[1,1,1],"pbrMetallicRoughness":{"metallicFactor":0.5,
    "baseColorTexture":{"index":0,"extensions":{"KHR_texture_transform":{"rotation":1}}},
    "metallicRoughnessTexture":{"index":0}}}],
    "textures":[{"source":0}],"images":[{"uri":"data:image/png;base64,)" +
              tiny_png_base64() + R"("}])";
  return text;
}

TEST(HostileFiles, gltf) { EXPECT_GT(survivors("t.gltf", {rich_gltf().json()}, read_gltf), 100); }

TEST(HostileFiles, glb) { EXPECT_GT(survivors("t.glb", {rich_gltf().glb()}, read_gltf), 100); }

Scene read_all_of_molecule(const Source& source, Warnings& warnings) {
  return read_molecule(source, {.waters = true}, warnings);
}

TEST(HostileFiles, pdb) {
  const std::string file =
      "HEADER    TEST\nMODEL        1\n"
      "ATOM      1  N   THR A   1      17.047  14.099   3.625  1.00 13.79           N  \n"
      "ATOM      2  CA ATHR A   1      16.967  12.784   4.338  1.00 10.80           C  \n"
      "HETATM    3 CA    CA A   2      11.967  12.784   4.338  1.00 10.80          CA  \n"
      "TER\nENDMDL\nCONECT    1    2    3\nEND\n";
  EXPECT_GT(survivors("t.pdb", {file}, read_all_of_molecule), 100);
}

TEST(HostileFiles, mmcif) {
  const std::string file =
      "data_T\n_a.b 'x y'\nloop_\n_atom_site.type_symbol\n_atom_site.label_atom_id\n"
      "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
      "C C1 1.0 2 3(4)\nO 'O1\"' 0 0 1.2\n;text\n;\n N 1 2 3\n# end\n";
  EXPECT_GT(survivors("t.cif", {file}, read_all_of_molecule), 100);
}

/// A scene of one triangle that wears the file as its texture.
Scene read_picture(const Source& source, Warnings&) {
  Scene scene;
  auto texture = decode_texture(source.bytes, ImageCoding::srgb, 1 << 20);
  if (!texture) throw Error({}, "no picture");
  scene.textures.push_back(std::move(*texture));
  scene.shapes.spheres.push_back({});
  return scene;
}

TEST(HostileFiles, pictures) {
  std::string tga(18, '\0');
  tga[2] = 10, tga[12] = 20, tga[14] = 20, tga[16] = 24;
  for (int i = 0; i < 20; ++i) tga += std::string("\x93\x01\x02\x03", 4);
  EXPECT_GT(survivors("t.tga", {tga}, read_picture), 100);
  const std::string png = *decode_data_uri("data:;base64," + tiny_png_base64());
  EXPECT_GT(survivors("t.png", {png}, read_picture), 100);
  const std::string jpeg = *decode_data_uri("data:;base64," + tiny_jpeg_base64());
  EXPECT_GT(survivors("t.jpg", {jpeg}, read_picture), 100);
  std::string bmp = "BM" + std::string(52, '\0') + std::string(16 * 3 * 16, 'x');
  bmp[10] = 54, bmp[14] = 40, bmp[18] = 16, bmp[22] = 16, bmp[26] = 1, bmp[28] = 24;
  EXPECT_GT(survivors("t.bmp", {bmp}, read_picture), 100);
}

}  // namespace
}  // namespace penumbra
