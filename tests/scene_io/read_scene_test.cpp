// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/read_scene.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tests/scene_io/text_source.h"

namespace penumbra {
namespace {

class ReadSceneTest : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  SceneFile read(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return read_scene(folder_ / name);
  }

  std::filesystem::path folder_ = std::filesystem::path(testing::TempDir()) /
                                  testing::UnitTest::GetInstance()->current_test_info()->name();
};

const std::string ply =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0 1 0 0 0 1 0 3 0 1 2\n";

TEST_F(ReadSceneTest, content_that_is_sure_beats_the_name) {
  const SceneFile file = read("a.obj", ply);
  EXPECT_EQ(file.scene.shapes.meshes.at(0).triangles.size(), 1u);
  ASSERT_EQ(file.warnings.size(), 1u);
  EXPECT_TRUE(holds(file.warnings[0], ".ply"));
  EXPECT_TRUE(read("b", ply).warnings.empty());
}

TEST_F(ReadSceneTest, names_the_file_and_counts_what_was_dropped) {
  const SceneFile file =
      read("a.nff", "p 3 0 0 0 1 1 1 2 2 2\np 3 0 0 0 0 0 0 1 0 0\np 3 0 0 0 1 0 0 0 1 0\n");
  EXPECT_EQ(file.scene.name, (folder_ / "a.nff").string());
  EXPECT_EQ(file.scene.shapes.meshes.at(0).triangles.size(), 1u);
  ASSERT_EQ(file.warnings.size(), 1u);
  EXPECT_TRUE(holds(file.warnings[0], "a.nff: 2 degenerate triangles"));
}

TEST_F(ReadSceneTest, errors_for_nothing_to_draw_and_unknown_formats) {
  EXPECT_TRUE(holds(error_of([&] { read("a.nff", "b 1 1 1\n"); }), "a.nff: "));
  EXPECT_TRUE(holds(error_of([&] { read("empty.ply", ""); }), "is empty"));
  EXPECT_TRUE(holds(error_of([&] { read("a.xyzzy", "1 2 3"); }), "use .nff, .obj"));
  EXPECT_TRUE(holds(error_of([&] { read("noname", "1 2 3"); }), "no extension"));
}

struct Expected {
  const char* name;
  std::size_t primitives, warnings;
};

TEST(RealFiles, have_the_counts_that_others_measured) {
  const char* data = std::getenv("PENUMBRA_DATA");
  if (data == nullptr) GTEST_SKIP() << "PENUMBRA_DATA names no folder";
  for (const Expected& e : {Expected{"spd/balls3.nff", 822, 0},
                            {"spd/balls4.nff.gz", 7383, 0},
                            {"spd/rings1.nff", 62, 0},
                            {"spd/rings3.nff", 842, 0},
                            {"spd/jacks1.nff", 9, 0},
                            {"spd/jacks3.nff", 657, 0},
                            {"spd/tetra.nff.gz", 4096, 0},
                            {"spd/mount.nff.gz", 8196, 0},
                            {"spd/teapot.nff.gz", 2328, 0},
                            {"mesh/snowden_bust.ply", 109259, 0},
                            {"mesh/bunny.ply.gz", 69451, 0},
                            {"mesh/bunny.stl.gz", 69451, 0},
                            {"mesh/dragon_871k.ply.gz", 871306, 1},
                            {"mesh/counter_83k.stl.gz", 83750, 0},
                            {"mesh/tray_bottom_ascii.stl.gz", 4520, 0},
                            {"mesh/spider_ascii.stl", 1312, 1},
                            {"mesh/origin_inside.stl", 28, 0}}) {
    const SceneFile file = read_scene(std::filesystem::path(data) / e.name);
    EXPECT_EQ(primitive_count(file.scene.shapes), e.primitives) << e.name;
    EXPECT_EQ(file.warnings.size(), e.warnings) << e.name;
  }
}

}  // namespace
}  // namespace penumbra
