// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

#include "penumbra/scene_io/assimp_import.h"
#include "penumbra/scene_io/child_process.h"
#include "tests/scene_io/text_source.h"

namespace penumbra {
namespace {

const std::string tetrahedron =
    "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

const std::string collada = R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><up_axis>Z_UP</up_axis></asset>
<library_effects><effect id="red-fx"><profile_COMMON><technique sid="t"><phong>
<diffuse><color>0.75 0.125 0.125 1</color></diffuse></phong></technique></profile_COMMON></effect>
</library_effects>
<library_materials><material id="red" name="red"><instance_effect url="#red-fx"/></material>
</library_materials>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="pa" count="9">
0 0 0 1 0 0 0 0 1</float_array><technique_common><accessor source="#pa" count="3" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
</accessor></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/>
</vertices><triangles count="1" material="m"><input semantic="VERTEX" source="#v" offset="0"/>
<p>0 1 2</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><translate>5 0 0</translate>
<instance_geometry url="#g"><bind_material><technique_common>
<instance_material symbol="m" target="#red"/></technique_common></bind_material>
</instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>
)";

Scene read(const Source& source) {
  Warnings warnings(source.path.string());
  Scene scene = read_assimp(source, warnings);
  validate(scene);
  return scene;
}

TEST(ReadAssimp, off) {
  const Scene scene = read(source_of("t.off", tetrahedron));
  ASSERT_EQ(scene.shapes.meshes.size(), 1u);
  EXPECT_EQ(scene.shapes.meshes[0].triangles.size(), 4u);
  EXPECT_EQ(scene.shapes.meshes[0].positions.size(), 4u);
  EXPECT_TRUE(scene.wants_ground);
}

TEST(ReadAssimp, collada_with_transform_up_axis_and_colour) {
  const Scene scene = read(source_of("t.dae", collada));
  const Mesh& mesh = scene.shapes.meshes.at(0);
  const Box box = bounds(mesh);
  EXPECT_NEAR(box.lo.x, 5, 1e-6);
  EXPECT_NEAR(box.hi.y, 1, 1e-6);  // its z is our y
  EXPECT_EQ(scene.materials[mesh.surface].diffuse, (Color{0.75f, 0.125f, 0.125f}));
}

TEST(ReadAssimp, the_second_set_of_texture_coordinates) {
  std::string text = collada;
  const auto insert = [&](const std::string& before, const std::string& what) {
    text.insert(text.find(before), what);
  };
  for (const char* set : {"s", "t"})
    insert("<vertices", std::string("<source id=\"") + set + "\"><float_array id=\"" + set +
                            "a\" count=\"6\">0 0 1 0 " + (*set == 's' ? "0 1" : "0.5 0.25") +
                            "</float_array><technique_common><accessor source=\"#" + set +
                            "a\" count=\"3\" stride=\"2\"><param name=\"S\" type=\"float\"/>"
                            "<param name=\"T\" type=\"float\"/></accessor></technique_common>"
                            "</source>");
  insert("<p>", R"(<input semantic="TEXCOORD" source="#s" offset="0" set="0"/>)"
                R"(<input semantic="TEXCOORD" source="#t" offset="0" set="1"/>)");
  const Mesh mesh = read(source_of("t.dae", text)).shapes.meshes.at(0);
  ASSERT_EQ(mesh.uvs.size(), 3u);
  ASSERT_EQ(mesh.lightmap_uvs.size(), 3u);
  EXPECT_EQ(mesh.uvs[2].v, 1);
  EXPECT_EQ(mesh.lightmap_uvs[2].u, 0.5f);
  EXPECT_EQ(mesh.lightmap_uvs[2].v, 0.25f);
}

TEST(ReadAssimp, damaged_files_are_errors_with_its_words) {
  const std::string error = error_of([] { read(source_of("t.dae", collada.substr(0, 500))); });
  EXPECT_TRUE(holds(error, "t.dae: assimp could not read it: "));
  EXPECT_TRUE(
      holds(error_of([] { read(source_of("t.off", "OFF\n4000000000 4 0\n")); }), "t.off: "));
  EXPECT_TRUE(holds(error_of([] { read(source_of("t.fbx", "Kaydara FBX Binary  ")); }), "t.fbx: "));
}

TEST(ReadAssimp, what_comes_back_is_not_believed) {
  const std::string packed = import_with_assimp(source_of("t.off", tetrahedron));
  EXPECT_EQ(unpack_assimp_scene(packed, "t.off").scene.shapes.meshes.size(), 1u);
  for (std::size_t size = 0; size < packed.size(); ++size)
    EXPECT_THROW(unpack_assimp_scene(packed.substr(0, size), "t.off"), Error) << size;
  for (std::size_t i = 0; i < packed.size(); ++i) {
    std::string damaged = packed;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x80);
    error_of([&] { unpack_assimp_scene(damaged, "t.off"); });
  }
}

TEST(ChildProcess, returns_what_work_returns) {
  const std::string large(3'000'000, 'x');
  const ChildResult result = run_in_child([&] { return large; });
  EXPECT_EQ(result.output, large);
  EXPECT_EQ(result.failure, "");
}

TEST(ChildProcess, crashes_hangs_and_exceptions_are_failures) {
  EXPECT_TRUE(holds(run_in_child([]() -> std::string {
                      std::raise(SIGSEGV);
                      return "";
                    }).failure,
                    "crashed (signal 11)"));
  EXPECT_TRUE(holds(run_in_child([]() -> std::string { std::abort(); }).failure, "signal 6"));
  EXPECT_EQ(run_in_child([]() -> std::string { throw 1; }).failure, "it failed");
  EXPECT_TRUE(
      holds(run_in_child([]() -> std::string { throw std::bad_alloc(); }).failure, "memory"));
  const auto forever = []() -> std::string {
    while (true) pause();
  };
  EXPECT_TRUE(holds(run_in_child(forever, {.wall_seconds = 1}).failure, "longer than 1 seconds"));
  const auto endless = [] { return std::string(10'000'000, 'x'); };
  EXPECT_TRUE(holds(run_in_child(endless, {.output_bytes = 1'000'000}).failure, "more than"));
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(ChildProcess, memory_is_limited) {
  const auto greedy = [] { return std::string(std::size_t{1} << 32, 'x').substr(0, 1); };
  EXPECT_TRUE(
      holds(run_in_child(greedy, {.memory_bytes = std::size_t{1} << 28}).failure, "memory"));
}
#endif

}  // namespace
}  // namespace penumbra
