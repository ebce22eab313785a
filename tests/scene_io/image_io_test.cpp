// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/image_io.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

#include "penumbra/scene/error.h"
#include "penumbra/scene_io/image_formats.h"

namespace penumbra {
namespace {

/// A folder of this test's own, removed at its end.
struct Folder {
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "penumbra-XXXXXX").string();
    path = ::mkdtemp(name.data());
  }
  ~Folder() { std::filesystem::remove_all(path); }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path), {}));
  }
  std::filesystem::path path;
};

std::string file_bytes(const std::filesystem::path& path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

/// R counts pixels, G and B are constant; everything in [0, 1].
Image ramp(std::uint32_t width, std::uint32_t height) {
  Image image{width, height, {}, {{"Software", "penumbra"}, {"Scene", "Büste.ply"}}};
  const std::size_t count = std::size_t{width} * height;
  image.channels = {{"R", std::vector<float>(count)},
                    {"G", std::vector<float>(count, 0.5f)},
                    {"B", std::vector<float>(count, 0.0f)}};
  for (std::size_t i = 0; i < count; ++i)
    image.channels[0].values[i] = static_cast<float>(i) / static_cast<float>(count);
  return image;
}

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](float x, float y) {
           return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
         });
}

TEST(ImageIo, PngHoldsTheSrgbCodesAndTheMetadata) {
  const Folder folder;
  const Image image = ramp(7, 5);
  write_image(folder.path / "a.png", image);
  const Image back = read_image(folder.path / "a.png");
  ASSERT_EQ(back.width, 7u);
  ASSERT_EQ(back.height, 5u);
  EXPECT_EQ(back.metadata, image.metadata);
  for (const char* name : {"R", "G", "B"})
    for (std::size_t i = 0; i < 35; ++i)
      EXPECT_EQ(std::lround(find_channel(back, name)->values[i] * 255),
                srgb_from_linear(find_channel(image, name)->values[i]));
  EXPECT_NE(file_bytes(folder.path / "a.png").find("sRGB"), std::string::npos);
  EXPECT_EQ(folder.files(), 1u) << "no temporary file stays";
}

TEST(ImageIo, ExposureCountsStops) {
  const Image image = ramp(4, 4);
  Image brighter = image;
  for (Channel& channel : brighter.channels)
    for (float& value : channel.values) value *= 4;
  EXPECT_EQ(to_png("x", image, 2), to_png("x", brighter, 0));
}

TEST(ImageIo, ExrKeepsEveryBitOfEveryLayer) {
  const Folder folder;
  Image image = ramp(33, 17);
  const float inf = std::numeric_limits<float>::infinity();
  image.channels[1].values[3] = std::numeric_limits<float>::quiet_NaN();
  image.channels[1].values[4] = inf;
  image.channels[1].values[5] = -0.0f;
  image.channels[1].values[6] = 1e-40f;
  image.channels.push_back({"class.light0", std::vector<float>(33 * 17, 2.0f)});
  write_image(folder.path / "a.exr", image);
  const Image back = read_image(folder.path / "a.exr");
  ASSERT_EQ(back.channels.size(), image.channels.size());
  for (const Channel& channel : image.channels) {
    const Channel* found = find_channel(back, channel.name);
    ASSERT_NE(found, nullptr) << channel.name;
    EXPECT_TRUE(same_bits(found->values, channel.values)) << channel.name;
  }
  EXPECT_EQ(back.metadata, image.metadata);
}

TEST(ImageIo, PngWithoutColoursIsAnError) {
  Image image = ramp(2, 2);
  image.channels.erase(image.channels.begin());
  EXPECT_THROW(to_png("x.png", image, 0), Error);
}

TEST(ImageIo, GreyPngHoldsPlainValuesOrSrgbCodes) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Image image{5, 1, {{"Y", {0, 0.25f, 1, 2, nan}}}, {{"Software", "test"}}};
  const auto stored = [&](const GreyCoding& coding, std::size_t i) {
    const Image back = from_png("x.png", to_grey_png("x.png", image, coding));
    EXPECT_EQ(back.metadata, image.metadata);
    return back.channels.at(0).values.at(i);
  };
  EXPECT_EQ(stored({}, 1), 64.0f / 255);
  EXPECT_EQ(stored({16, false}, 1), 16384.0f / 65535);
  EXPECT_EQ(stored({8, true}, 1), 137.0f / 255);
  for (const GreyCoding coding : {GreyCoding{}, GreyCoding{16, false}, GreyCoding{8, true}}) {
    EXPECT_EQ(stored(coding, 0), 0);
    EXPECT_EQ(stored(coding, 2), 1);
    EXPECT_EQ(stored(coding, 3), 1);
    EXPECT_EQ(stored(coding, 4), 0);
  }
  EXPECT_THROW(to_grey_png("x.png", ramp(2, 2), {}), Error);
}

TEST(ImageIo, EveryTruncationIsAnError) {
  const std::string png = to_png("x", ramp(9, 9), 0), exr = to_exr("x", ramp(9, 9));
  for (std::size_t size = 0; size < png.size(); ++size)
    EXPECT_THROW(from_png("x", std::string_view(png).substr(0, size)), Error) << size;
  for (std::size_t size = 0; size < exr.size(); ++size)
    EXPECT_THROW(from_exr("x", std::string_view(exr).substr(0, size)), Error) << size;
}

template <typename Read>
void read_damaged(const std::string& whole, const Read& read) {
  const int rounds = std::getenv("PENUMBRA_LONG_FUZZ") ? 200000 : 2000;
  std::mt19937 random(1);
  for (int i = 0; i < rounds; ++i) {
    std::string bytes = whole;
    for (int damage = 0; damage < 1 + i % 4; ++damage)
      bytes[random() % bytes.size()] = static_cast<char>(random());
    try {
      const Image image = read(bytes);
      for (const Channel& channel : image.channels)
        ASSERT_EQ(channel.values.size(), std::size_t{image.width} * image.height);
    } catch (const Error&) {
    }
  }
}

TEST(ImageIo, DamagedFilesGiveAPictureOrAnError) {
  read_damaged(to_png("x", ramp(9, 9), 0),
               [](const std::string& bytes) { return from_png("x", bytes); });
  read_damaged(to_exr("x", ramp(9, 9)),
               [](const std::string& bytes) { return from_exr("x", bytes); });
}

/// Sets the width and height of a PNG, checksum included.
std::string with_size(std::string png, std::uint32_t width, std::uint32_t height) {
  const auto put = [&png](std::size_t at, std::uint32_t value) {
    for (int i = 0; i < 4; ++i) png[at + i] = static_cast<char>(value >> (24 - 8 * i));
  };
  put(16, width);
  put(20, height);
  const auto* header = reinterpret_cast<const Bytef*>(png.data() + 12);
  put(29, static_cast<std::uint32_t>(::crc32(0, header, 17)));
  return png;
}

TEST(ImageIo, ClaimsOfHugePicturesAreRefused) {
  const std::string png = to_png("x", ramp(4, 4), 0);
  EXPECT_NO_THROW(from_png("x", with_size(png, 4, 4)));
  EXPECT_THROW(from_png("x", with_size(png, 65535, 65535)), Error);
  EXPECT_THROW(from_png("x", with_size(png, 0x7fffffff, 0x7fffffff)), Error);
  EXPECT_THROW(check_picture_size("x", 1u << 28, 2, 1, ~std::size_t{0} >> 16), Error);
  EXPECT_THROW(check_picture_size("x", ~0ull, ~0ull, 1, 1), Error);
  EXPECT_THROW(check_picture_size("x", 1u << 14, 1u << 14, 12, 1000), Error);
  EXPECT_NO_THROW(check_picture_size("x", 1u << 14, 1u << 14, 12, 1u << 20));
}

TEST(ImageIo, PathsAreCheckedWithoutLeavingAFile) {
  const Folder folder;
  EXPECT_NO_THROW(check_image_path(folder.path / "a.png"));
  EXPECT_NO_THROW(check_image_path(folder.path / "A.EXR"));
  EXPECT_EQ(folder.files(), 0u);
  EXPECT_THROW(check_image_path(folder.path / "a.jpg"), Error);
  EXPECT_THROW(check_image_path(folder.path / "none" / "a.png"), Error);
  EXPECT_THROW(check_image_path(""), Error);
  std::filesystem::create_directory(folder.path / "folder.png");
  EXPECT_THROW(check_image_path(folder.path / "folder.png"), Error);
  EXPECT_THROW(write_image(folder.path / "none" / "a.png", ramp(2, 2)), Error);
  EXPECT_THROW(read_image(folder.path / "a.png"), Error);
}

}  // namespace
}  // namespace penumbra
