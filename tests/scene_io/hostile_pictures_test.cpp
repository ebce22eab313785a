// SPDX-License-Identifier: MIT
// Pictures that were damaged by chance: a texture, or nothing. (Scenes: corpus_test.cpp.)
#include <gtest/gtest.h>

#include <string>

#include "penumbra/scene_io/gltf_uri.h"
#include "penumbra/scene_io/texture_io.h"
#include "tests/scene_io/fuzz/mutation.h"
#include "tests/scene_io/gltf_text.h"

namespace penumbra {
namespace {

/// How many of the damaged pictures were still read.
int survivors(const std::string& sample) {
  int count = 0;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    Dice dice(seed);
    const std::string bytes = damaged({sample}, dice);
    const auto texture = decode_texture(bytes, ImageCoding::srgb, 1 << 20);
    if (!texture) continue;
    EXPECT_EQ(texture->pixels.size(), std::size_t{texture->width} * texture->height);
    ++count;
  }
  return count;
}

TEST(HostilePictures, png) {
  EXPECT_GT(survivors(*decode_data_uri("data:;base64," + tiny_png_base64())), 10);
}

TEST(HostilePictures, jpeg) {
  EXPECT_GT(survivors(*decode_data_uri("data:;base64," + tiny_jpeg_base64())), 100);
}

TEST(HostilePictures, tga) {
  std::string tga(18, '\0');
  tga[2] = 10, tga[12] = 20, tga[14] = 20, tga[16] = 24;
  for (int i = 0; i < 20; ++i) tga += std::string("\x93\x01\x02\x03", 4);
  EXPECT_GT(survivors(tga), 100);
}

TEST(HostilePictures, bmp) {
  std::string bmp = "BM" + std::string(52, '\0') + std::string(16 * 3 * 16, 'x');
  bmp[10] = 54, bmp[14] = 40, bmp[18] = 16, bmp[22] = 16, bmp[26] = 1, bmp[28] = 24;
  EXPECT_GT(survivors(bmp), 100);
}

}  // namespace
}  // namespace penumbra
