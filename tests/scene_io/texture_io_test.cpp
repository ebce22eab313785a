// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/texture_io.h"

#include <gtest/gtest.h>

#include <string>

#include "penumbra/scene_io/gltf_uri.h"
#include "tests/scene_io/gltf_text.h"
#include "tests/scene_io/temporary_folder.h"
#include "tests/scene_io/text_source.h"

namespace penumbra {
namespace {

/// The head of a TGA of 24 bits a pixel.
std::string tga_head(int width, int height) {
  std::string head(18, '\0');
  head[2] = 2, head[16] = 24;
  head[12] = static_cast<char>(width & 0xFF), head[13] = static_cast<char>(width >> 8);
  head[14] = static_cast<char>(height & 0xFF), head[15] = static_cast<char>(height >> 8);
  return head;
}

TEST(DecodeTexture, colours_become_linear_and_numbers_stay) {
  const std::string grey = tga_head(1, 1) + "\x80\x80\x80";
  EXPECT_NEAR(decode_texture(grey, ImageCoding::srgb, 10)->pixels[0].x, 0.2158605, 1e-6);
  EXPECT_NEAR(decode_texture(grey, ImageCoding::plain, 10)->pixels[0].x, 128.0 / 255, 1e-6);
}

TEST(DecodeTexture, claims_need_bytes_to_back_them) {
  const std::string claim = tga_head(60000, 60000) + "\x80\x80\x80";
  EXPECT_FALSE(decode_texture(claim, ImageCoding::srgb, std::size_t{1} << 40));
  const std::string square = tga_head(2, 2) + std::string(12, '\x7f');
  EXPECT_TRUE(decode_texture(square, ImageCoding::srgb, 4));
  EXPECT_FALSE(decode_texture(square, ImageCoding::srgb, 3));
  EXPECT_FALSE(decode_texture("", ImageCoding::srgb, 100));
  EXPECT_FALSE(decode_texture("no picture at all, but text", ImageCoding::srgb, 100));
}

TEST(DecodeTexture, png_and_jpeg) {
  const auto texture_of = [](const std::string& base64_text) {
    return decode_texture(*decode_data_uri("data:;base64," + base64_text), ImageCoding::plain, 200);
  };
  EXPECT_EQ(texture_of(tiny_png_base64())->pixels.size(), 1u);
  const auto jpeg = texture_of(tiny_jpeg_base64());
  ASSERT_TRUE(jpeg);
  EXPECT_EQ(jpeg->width, 16u);
  EXPECT_EQ(jpeg->height, 8u);
  EXPECT_GT(jpeg->pixels.front().x, 0.9f);
  EXPECT_LT(jpeg->pixels.back().x, 0.1f);
}

TEST(FindBeside, files_alone_and_absolute_paths_by_their_last_part) {
  TemporaryFolder folder;
  const auto scene = folder.put("scene.obj", ""), picture = folder.put("a.png", "");
  std::filesystem::create_directory(folder.path() / "sub");
  const auto nested = folder.put("sub/b.png", "");
  EXPECT_EQ(find_beside(scene, "a.png"), picture);
  EXPECT_EQ(find_beside(scene, "elsewhere/a.png"), picture);
  EXPECT_EQ(find_beside(scene, "C:\\pictures\\a.png"), picture);
  EXPECT_EQ(find_beside(scene, "/etc/a.png"), picture);
  EXPECT_EQ(find_beside(scene, "sub\\b.png"), nested);
  EXPECT_FALSE(find_beside(scene, "/etc/passwd"));
  EXPECT_FALSE(find_beside(scene, "sub"));
  EXPECT_FALSE(find_beside(scene, "b.png"));
  EXPECT_FALSE(find_beside(scene, ""));
  EXPECT_FALSE(find_beside(scene, std::string_view("a.png\0", 6)));
}

TEST(TextureLoader, damaged_files_are_a_warning_and_no_texture) {
  TemporaryFolder folder;
  folder.put("a.png", "not a picture");
  const Source source{folder.path() / "t.obj", "obj", ""};
  Scene scene;
  Warnings warnings("t.obj");
  TextureLoader textures(source, scene, warnings);
  EXPECT_EQ(textures.from_file("a.png"), -1);
  EXPECT_EQ(textures.from_file("a.png"), -1);
  ASSERT_EQ(warnings.lines().size(), 1u);
  EXPECT_TRUE(holds(warnings.lines()[0], "a.png is no PNG"));
}

TEST(DecodeTexture, chunks_that_claim_more_than_there_is_are_not_believed) {
  const std::string png = *decode_data_uri("data:;base64," + tiny_png_base64());
  const std::size_t data = png.find("IDAT");
  ASSERT_NE(data, png.npos);
  std::string greedy = png;
  greedy.replace(data - 4, 4, std::string("\x40\0\0\0", 4));
  // stb would ask for a gigabyte first.
  EXPECT_FALSE(decode_texture(greedy, ImageCoding::srgb, 10));
  EXPECT_TRUE(decode_texture(png + "more", ImageCoding::srgb, 10));
}

TEST(MostPixels, of_small_files_are_bounded_and_of_large_ones_earned) {
  EXPECT_EQ(most_pixels_of(0), std::size_t{1} << 25);
  EXPECT_EQ(most_pixels_of(1'000'000), std::size_t{1} << 25);
  EXPECT_EQ(most_pixels_of(2'000'000), (std::size_t{1} << 25) + 16'000'000);
  EXPECT_EQ(most_pixels_of(1'000'000'000), std::size_t{1} << 27);
}

}  // namespace
}  // namespace penumbra
