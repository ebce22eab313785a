// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/gltf_placement.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/scene_io/gltf_read.h"

namespace penumbra {
namespace {

TEST(GltfPlacement, nodes_are_placed_by_matrix_or_parts_through_their_parents) {
  GltfText text;
  text.nodes = R"({"children":[1],"translation":[10,0,0],"scale":[2,2,2]},
    {"mesh":0,"rotation":[0,0,0.70710678118654752,0.70710678118654752]})";
  const Vec3f turned = read(text).scene.shapes.meshes[0].positions[1];
  EXPECT_NEAR(turned.x, 10, 1e-6);
  EXPECT_NEAR(turned.y, 2, 1e-6);
  text.nodes = R"({"mesh":0,"matrix":[0,1,0,0, -1,0,0,0, 0,0,1,0, 5,6,7,1]})";
  EXPECT_EQ(read(text).scene.shapes.meshes[0].positions[1], (Vec3f{5, 7, 7}));
}

TEST(GltfPlacement, a_mesh_of_many_nodes_is_a_group_that_each_places) {
  GltfText text;
  text.scene_nodes = "0,1";
  text.nodes = R"({"mesh":0},{"mesh":0,"translation":[0,0,9],"scale":[-1,2,2]})";
  const ShapeSet shapes = parsed(text).shapes;
  EXPECT_TRUE(shapes.meshes.empty());
  ASSERT_EQ(shapes.groups.size(), 1u);
  ASSERT_EQ(shapes.groups[0].meshes.size(), 1u);
  EXPECT_EQ(shapes.groups[0].meshes[0].positions[1], (Vec3f{1, 0, 0}));
  ASSERT_EQ(shapes.instances.size(), 2u);
  EXPECT_TRUE((shapes.instances[0].placement.offset == Vec3d{}));
  EXPECT_TRUE((shapes.instances[1].placement.offset == Vec3d{0, 0, 9}));
  EXPECT_LT(determinant(shapes.instances[1].placement), 0);
}

TEST(GltfPlacement, what_a_node_flattens_is_no_instance) {
  GltfText text;
  text.scene_nodes = "0,1,2";
  text.nodes = R"({"mesh":0},{"mesh":0,"scale":[1,1,0]},{"mesh":0,"translation":[1,0,0]})";
  const ShapeSet shapes = parsed(text).shapes;
  EXPECT_EQ(shapes.instances.size(), 2u);
  ASSERT_EQ(shapes.meshes.size(), 1u);
  EXPECT_EQ(shapes.meshes[0].positions[1], (Vec3f{1, 0, 0}));
}

TEST(GltfPlacement, mirrored_meshes_keep_their_outside_outside) {
  GltfText text;
  text.nodes = R"({"mesh":0,"scale":[-1,1,1]})";
  const Mesh mesh = read(text).scene.shapes.meshes[0];
  const Triangle t = mesh.triangles[0];
  const Vec3f normal = cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                             mesh.positions[t[2]] - mesh.positions[t[0]]);
  EXPECT_EQ(mesh.positions[1], (Vec3f{-1, 0, 0}));
  EXPECT_GT(normal.z, 0);  // as it was before
}

TEST(GltfPlacement, instances_on_the_gpu_are_copies) {
  GltfText text;
  // The third accessor: as many translations as the square has corners.
  text.indices += R"(},{"bufferView":0,"componentType":5126,"type":"VEC3","count":4)";
  text.nodes = R"({"mesh":0,"scale":[2,2,2],"extensions":{"EXT_mesh_gpu_instancing":
    {"attributes":{"TRANSLATION":2,"SCALE":2}}}})";
  text.rest = R"(,"extensionsRequired":["EXT_mesh_gpu_instancing"])";
  const ShapeSet flat = parsed(text).shapes;  // each corner has a 0 somewhere
  EXPECT_EQ(flat.meshes.size(), 4u);
  text.nodes = R"({"mesh":0,"scale":[2,2,2],"extensions":{"EXT_mesh_gpu_instancing":
    {"attributes":{"TRANSLATION":2}}}})";
  const ShapeSet shapes = parsed(text).shapes;
  ASSERT_EQ(shapes.instances.size(), 4u);
  EXPECT_TRUE((shapes.instances[3].placement.offset == Vec3d{2, 2, 0}));
  EXPECT_TRUE((shapes.instances[3].placement.x_axis == Vec3d{2, 0, 0}));
  text.nodes = R"({"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":
    {"attributes":{"TRANSLATION":2,"ROTATION":2}}}})";
  EXPECT_TRUE(holds(error_in(text), "ROTATION of a node's copies"));
}

TEST(GltfPlacement, hidden_nodes_are_left_out_with_their_children) {
  GltfText text;
  text.nodes = R"({"children":[1]},{"children":[2],"mesh":0},{"mesh":0})";
  EXPECT_EQ(parsed(text).shapes.instances.size(), 2u);
  text.nodes = R"({"mesh":0,"children":[1]},{"children":[2],
    "extensions":{"KHR_node_visibility":{"visible":false}}},{"mesh":0})";
  EXPECT_EQ(read(text).scene.shapes.meshes.size(), 1u);
}

}  // namespace
}  // namespace penumbra
