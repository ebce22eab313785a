// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/jpeg_io.h"

#include <gtest/gtest.h>

#include <cmath>

#include "penumbra/scene/error.h"

namespace penumbra {
namespace {

Image flat(std::uint32_t width, std::uint32_t height, float red, float green, float blue) {
  const std::size_t count = std::size_t{width} * height;
  return {width,
          height,
          {{"R", std::vector<float>(count, red)},
           {"G", std::vector<float>(count, green)},
           {"B", std::vector<float>(count, blue)}},
          {}};
}

TEST(EncodeJpeg, DecodesToTheCodesOfThePngWriter) {
  const JpegImage image = decode_jpeg(encode_jpeg(flat(33, 17, 0.8f, 0.2f, 0.05f), 95), 10000);
  ASSERT_EQ(image.width, 33u);
  ASSERT_EQ(image.height, 17u);
  for (std::size_t i = 0; i < image.codes.size(); i += 3) {
    ASSERT_NEAR(image.codes[i], srgb_from_linear(0.8f), 3);
    ASSERT_NEAR(image.codes[i + 1], srgb_from_linear(0.2f), 3);
    ASSERT_NEAR(image.codes[i + 2], srgb_from_linear(0.05f), 3);
  }
}

TEST(EncodeJpeg, ExposureDoublesLight) {
  EXPECT_EQ(encode_jpeg(flat(8, 8, 0.2f, 0.2f, 0.2f), 90, 1),
            encode_jpeg(flat(8, 8, 0.4f, 0.4f, 0.4f), 90));
}

TEST(EncodeJpeg, ColoursKeepTheirResolution) {
  Image image = flat(16, 16, 1, 0, 0);
  for (std::size_t i = 1; i < 256; i += 2) image.channels[0].values[i] = 0;
  for (std::size_t i = 1; i < 256; i += 2) image.channels[2].values[i] = 1;
  const JpegImage read = decode_jpeg(encode_jpeg(image, 95), 10000);
  ASSERT_EQ(read.codes.size(), 768u);
  EXPECT_GT(read.codes[0], 220);
  EXPECT_LT(read.codes[3], 35);
}

TEST(EncodeJpeg, SaysWhatItCannotWrite) {
  EXPECT_THROW(encode_jpeg(Image{4, 4, {}, {}}, 90), Error);
  EXPECT_THROW(encode_jpeg(flat(0, 0, 0, 0, 0), 90), Error);
  EXPECT_THROW(encode_jpeg(flat(65536, 1, 0, 0, 0), 90), Error);
}

}  // namespace
}  // namespace penumbra
