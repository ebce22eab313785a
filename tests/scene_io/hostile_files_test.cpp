// SPDX-License-Identifier: MIT
// Files that were damaged by chance: a reader gives a scene or throws Error, and does so soon.
// PENUMBRA_LONG_FUZZ=<rounds> for more than the usual few thousand.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "penumbra/scene_io/write_scene.h"
#include "tests/scene_io/text_source.h"

namespace penumbra {
namespace {

/// xorshift64*: the same damage in every run.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed * 2 + 1) {}
  std::size_t below(std::size_t limit) {
    state_ ^= state_ >> 12;
    state_ ^= state_ << 25;
    state_ ^= state_ >> 27;
    return limit == 0 ? 0 : (state_ * 0x2545F4914F6CDD1Du >> 33) % limit;
  }

 private:
  std::uint64_t state_;
};

const std::vector<std::string> nasty = {"-1",
                                        "0",
                                        "nan",
                                        "inf",
                                        "1e39",
                                        "1e-50",
                                        "\xff\xff\xff\xff",
                                        "4294967295",
                                        "9223372036854775807",
                                        "#",
                                        "\n",
                                        " ",
                                        "p",
                                        "3",
                                        std::string(4, '\0'),
                                        "\x7f\xff\xff\xff",
                                        "list",
                                        "1.5"};

std::string damaged(std::string bytes, Dice& dice) {
  for (std::size_t times = 1 + dice.below(4); times > 0; --times) {
    const std::size_t at = dice.below(bytes.size());
    const std::size_t length = 1 + dice.below(12);
    switch (dice.below(6)) {
      case 0:
        if (!bytes.empty()) bytes[at] = static_cast<char>(dice.below(256));
        break;
      case 1: bytes.erase(at, length); break;
      case 2: bytes.insert(at, bytes.substr(dice.below(bytes.size()), length)); break;
      case 3: bytes.insert(at, nasty[dice.below(nasty.size())]); break;
      case 4: bytes.replace(at, length, nasty[dice.below(nasty.size())]); break;
      case 5: bytes.resize(at); break;
    }
  }
  return bytes;
}

using Reader = Scene (*)(const Source&, Warnings&);

/// How many of the damaged files were still read: some, or the damage is too much to be a test.
int survivors(const std::vector<std::string>& samples, Reader read) {
  const char* setting = std::getenv("PENUMBRA_LONG_FUZZ");
  const std::uint64_t rounds = setting != nullptr ? std::strtoull(setting, nullptr, 10) : 3000;
  int count = 0;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    Dice dice(round);
    const Source source = source_of("t.x", damaged(samples[round % samples.size()], dice));
    Warnings warnings("t.x");
    try {
      Scene scene = read(source, warnings);
      validate(scene);
      ++count;
    } catch (const Error& error) {
      EXPECT_TRUE(std::string(error.what()).size() < 500) << error.what();
    }
  }
  return count;
}

TEST(HostileFiles, nff) {
  const std::string sample =
      "b 0.1 0.2 0.3\nv\nfrom 1 -5 1\nat 0 0 0\nup 0 0 1\nangle 45\nhither 0.1\nresolution 64 64\n"
      "l 1 2 3\n#! light sphere 0 0 9 1\nf 1 0.5 0.2 0.5 0.5 3 0 1\n#! material emission 1 2 3\n"
      "s 0 0 0 1\n#! capped\nc 0 0 0 1 0 0 2 1\n#! backdrop\np 4 0 0 0 1 0 0 1 1 0 0 1 0\n"
      "#! mesh\np 5 4 0 0 0 3 0 1 0 0 0 -3 0 1 -4 0\npp 3 0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1\n"
      "#! ring 0 0 1\nc 0 0 0 1 0 0 0 2\n";
  EXPECT_GT(survivors({sample}, read_nff), 0);
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
  EXPECT_GT(survivors({text, little, big}, read_ply), 0);
}

TEST(HostileFiles, stl) {
  std::string text = "solid s\n";
  for (int i = 0; i < 4; ++i)
    text += "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 " +
            std::to_string(i) + "\nendloop\nendfacet\n";
  std::string binary(84 + 4 * 50, '\x3f');
  binary.replace(80, 4, std::string("\x04\0\0\0", 4));
  EXPECT_GT(survivors({text + "endsolid s\n", binary}, read_stl), 0);
}

}  // namespace
}  // namespace penumbra
