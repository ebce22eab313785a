// SPDX-License-Identifier: MIT
#include "html.h"

#include <gtest/gtest.h>

#include "penumbra/scene_io/gltf_uri.h"
#include "penumbra/scene_io/image_formats.h"
#include "penumbra/scene_io/jpeg_io.h"
#include "plain_text.h"

namespace penumbra::reproduce {
namespace {

TEST(Escape, NothingMeansAnything) {
  EXPECT_EQ(escape("<a b=\"c\" d='e'> & é\n"), "&lt;a b=&quot;c&quot; d=&#39;e&#39;&gt; &amp; é ");
}

TEST(PlainText, IsOneLineOfUtf8) {
  EXPECT_EQ(plain_text("a\tb\nc\x7f é ’ 𝛀"), "a b c  é ’ 𝛀");
  EXPECT_EQ(plain_text("\xE9t\xE9 \xC3"), "?t? ?");
  EXPECT_EQ(plain_text("\xC0\x80 \xE0\x80\x80 \xED\xA0\x80 \xF4\x90\x80\x80"), "?? ??? ??? ????");
}

TEST(FileLink, IsAFileBesideThePage) {
  EXPECT_EQ(file_link("a b/c-1_2.png"), "a%20b/c-1_2.png");
  EXPECT_EQ(file_link("javascript:x?y#z%\"é"), "javascript%3Ax%3Fy%23z%25%22%C3%A9");
}

TEST(DataUri, DecodesToTheSameBytes) {
  for (const std::string bytes : {"", "a", "ab", "abc", "\xFF\xFE\x01\x80"})
    EXPECT_EQ(decode_data_uri(data_uri("image/png", bytes)), bytes);
}

TEST(PictureSize, IsWhatTheHeadSays) {
  const std::vector<float> values(7 * 5);
  const Image image{7, 5, {{"R", values}, {"G", values}, {"B", values}}, {}};
  for (const std::string& bytes :
       {to_png("", image, 0), encode_jpeg(image, 90),
        std::string("<?xml version=\"1.0\"?>\n<svg \n width=\"7\" height=\"5\" viewBox=\"\">")}) {
    EXPECT_EQ(picture_size(bytes).width, 7u);
    EXPECT_EQ(picture_size(bytes).height, 5u);
    for (std::size_t i = 0; i < bytes.size(); ++i) picture_size(bytes.substr(0, i));  // ends
  }
  EXPECT_EQ(picture_size("GIF89a").width, 0u);
}

}  // namespace
}  // namespace penumbra::reproduce
