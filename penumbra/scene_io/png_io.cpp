// SPDX-License-Identifier: MIT
#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstring>
#include <vector>

#include "penumbra/scene/error.h"
#include "penumbra/scene_io/image_formats.h"

namespace penumbra {
namespace {

/// What libpng's callbacks share with us: the last message, and where bytes come from or go to.
struct Stream {
  std::array<char, 200> message{};
  std::string_view in;
  std::size_t position = 0;
  std::string* out = nullptr;
};

void keep_message(png_structp png, png_const_charp text) {
  Stream& stream = *static_cast<Stream*>(png_get_error_ptr(png));
  std::strncpy(stream.message.data(), text, stream.message.size() - 1);
  png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

void read_bytes(png_structp png, png_bytep to, std::size_t count) {
  Stream& stream = *static_cast<Stream*>(png_get_io_ptr(png));
  if (count > stream.in.size() - stream.position) png_error(png, "the file ends too early");
  std::memcpy(to, stream.in.data() + stream.position, count);
  stream.position += count;
}

void write_bytes(png_structp png, png_bytep from, std::size_t count) {
  Stream& stream = *static_cast<Stream*>(png_get_io_ptr(png));
  bool is_stored = true;
  try {
    stream.out->append(reinterpret_cast<const char*>(from), count);
  } catch (const std::exception&) {
    is_stored = false;  // no C++ exception may cross libpng's frames
  }
  if (!is_stored) png_error(png, "out of memory");
}

void flush_nothing(png_structp) {}

/// libpng's reading or writing state; freed however its use ends.
struct Reader {
  explicit Reader(Stream& stream)
      : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &stream, keep_message, ignore_warning)),
        info(png ? png_create_info_struct(png) : nullptr) {}
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  png_structp png;
  png_infop info;
};

struct Writer {
  explicit Writer(Stream& stream)
      : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, &stream, keep_message, ignore_warning)),
        info(png ? png_create_info_struct(png) : nullptr) {}
  ~Writer() { png_destroy_write_struct(&png, &info); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  png_structp png;
  png_infop info;
};

/// Runs `step`, out of which libpng may jump; false if it did. `step` must own nothing that needs a
/// destructor (all memory belongs to the caller), so the jump skips none.
template <typename Step>
bool survives(png_structp png, const Step& step) {
  if (setjmp(png_jmpbuf(png))) return false;
  step();
  return true;
}

[[noreturn]] void fail(const std::filesystem::path& name, const Stream& stream,
                       const std::string& what, const std::string& hint) {
  throw Error({name.string(), {}, {}}, what + " (" + stream.message.data() + ")", hint);
}

/// Rows of an array of pixels, in the form libpng takes.
std::vector<png_bytep> rows_of(std::vector<png_byte>& pixels, std::size_t height) {
  std::vector<png_bytep> rows(height);
  for (std::size_t y = 0; y < height; ++y) rows[y] = pixels.data() + y * (pixels.size() / height);
  return rows;
}

/// Keywords are 1 to 79 bytes. tEXt holds Latin-1 alone: what is not ASCII goes to iTXt as UTF-8.
std::vector<png_text> text_chunks(const Image& image) {
  std::vector<png_text> chunks;
  for (const auto& [key, value] : image.metadata) {
    const bool is_ascii =
        std::all_of(value.begin(), value.end(), [](unsigned char c) { return c < 128; });
    png_text text{};
    text.compression = is_ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    text.key = const_cast<char*>(key.c_str());
    text.text = const_cast<char*>(value.c_str());
    chunks.push_back(text);
  }
  return chunks;
}

/// What png_read_image will deliver: three colours of 8 or 16 bits.
struct Layout {
  png_uint_32 width = 0, height = 0;
  int bits = 8;
  int color_type = 0;
};

constexpr const char* read_hint = "is it a PNG, and whole? Make or copy it again";

/// Throws where a chunk (length, type, data, checksum) claims more bytes than there are: libpng
/// would allocate them.
void check_chunks(const std::filesystem::path& name, std::string_view bytes) {
  constexpr std::size_t signature = 8, frame = 12;
  const auto* data = reinterpret_cast<png_const_bytep>(bytes.data());
  if (bytes.size() < signature || png_sig_cmp(data, 0, signature) != 0)
    throw Error({name.string(), {}, 0}, "its first bytes are not those of a PNG", read_hint);
  std::size_t at = signature;
  while (at < bytes.size()) {
    const std::size_t rest = bytes.size() - at;
    if (rest < frame || png_get_uint_32(data + at) > rest - frame)
      throw Error({name.string(), {}, at}, "a chunk claims more bytes than the file has",
                  read_hint);
    at += frame + png_get_uint_32(data + at);
  }
}

void ask_for_rgb(png_structp png) {
  png_set_expand(png);  // palettes and fewer than 8 bits
  png_set_gray_to_rgb(png);
  png_set_strip_alpha(png);
}

Image to_image(const Layout& layout, const std::vector<png_byte>& pixels) {
  Image image{layout.width, layout.height, {}, {}};
  const std::size_t count = std::size_t{layout.width} * layout.height;
  int color = 0;
  for (const char* name : {"R", "G", "B"}) {
    Channel channel{name, std::vector<float>(count)};
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t at = 3 * i + color;
      channel.values[i] =
          layout.bits == 16 ? static_cast<float>(pixels[2 * at] * 256 + pixels[2 * at + 1]) / 65535
                            : static_cast<float>(pixels[at]) / 255;
    }
    image.channels.push_back(std::move(channel));
    ++color;
  }
  return image;
}

}  // namespace

namespace {

struct Encoding {
  int bits = 8, color_type = PNG_COLOR_TYPE_RGB;
  bool is_srgb = true;  ///< and says so
};

/// `pixels` are codes row by row, of 16 bits the high byte first.
std::string encode(const std::filesystem::path& name, const Image& image, const Encoding& encoding,
                   std::vector<png_byte> pixels) {
  const std::vector<png_bytep> rows = rows_of(pixels, image.height);
  const std::vector<png_text> texts = text_chunks(image);
  std::string bytes;
  Stream stream;
  stream.out = &bytes;
  const Writer writer(stream);
  const bool is_written =
      writer.info && survives(writer.png, [&] {
        png_set_write_fn(writer.png, &stream, write_bytes, flush_nothing);
        png_set_IHDR(writer.png, writer.info, image.width, image.height, encoding.bits,
                     encoding.color_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                     PNG_FILTER_TYPE_DEFAULT);
        if (encoding.is_srgb)
          png_set_sRGB_gAMA_and_cHRM(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
        png_set_text(writer.png, writer.info, texts.data(), static_cast<int>(texts.size()));
        png_write_info(writer.png, writer.info);
        png_write_image(writer.png, const_cast<png_bytepp>(rows.data()));
        png_write_end(writer.png, writer.info);
      });
  if (!is_written) fail(name, stream, "cannot be written as PNG", "write it as .exr");
  return bytes;
}

}  // namespace

std::string to_png(const std::filesystem::path& name, const Image& image, float exposure_ev) {
  return encode(name, image, {}, srgb_codes(name, image, exposure_ev));
}

std::string to_grey_png(const std::filesystem::path& name, const Image& image,
                        const GreyCoding& coding) {
  const std::size_t count = std::size_t{image.width} * image.height;
  const Channel* channel = image.channels.size() == 1 ? image.channels.data() : nullptr;
  if (!channel || channel->values.size() != count)
    throw Error({name.string(), {}, {}}, "a grey PNG has one channel", "write these as .exr");
  std::vector<png_byte> pixels;
  pixels.reserve(count * coding.bits / 8);
  for (const float value : channel->values) {
    const double light = value > 0 ? std::min(1.0, double{value}) : 0;  // NaN: 0
    if (coding.bits == 16) {
      const auto code = static_cast<unsigned>(light * 65535 + 0.5);
      pixels.push_back(static_cast<png_byte>(code >> 8));
      pixels.push_back(static_cast<png_byte>(code & 255));
    } else {
      pixels.push_back(coding.is_srgb ? srgb_from_linear(value)
                                      : static_cast<png_byte>(light * 255 + 0.5));
    }
  }
  return encode(name, image, {coding.bits, PNG_COLOR_TYPE_GRAY, coding.is_srgb}, std::move(pixels));
}

Image from_png(const std::filesystem::path& name, std::string_view bytes) {
  check_chunks(name, bytes);
  constexpr png_alloc_size_t most_unpacked_text = 1 << 23;
  Stream stream;
  stream.in = bytes;
  const Reader reader(stream);
  Layout layout;
  if (!reader.info || !survives(reader.png, [&] {
        png_set_read_fn(reader.png, &stream, read_bytes);
        png_set_chunk_malloc_max(reader.png, most_unpacked_text);
        png_read_info(reader.png, reader.info);
        png_get_IHDR(reader.png, reader.info, &layout.width, &layout.height, &layout.bits,
                     &layout.color_type, nullptr, nullptr, nullptr);
      }))
    fail(name, stream, "cannot be read as PNG", read_hint);
  const std::size_t pixel_bytes = layout.bits == 16 ? 6 : 3;
  // A palette or grey file may hold one bit where three bytes come out.
  check_picture_size(name, layout.width, layout.height, 1, bytes.size() * 8);

  std::vector<png_byte> pixels(pixel_bytes * layout.width * layout.height);
  const std::vector<png_bytep> rows = rows_of(pixels, layout.height);
  png_textp texts = nullptr;
  int text_count = 0;
  if (!survives(reader.png, [&] {
        ask_for_rgb(reader.png);
        png_set_interlace_handling(reader.png);
        png_read_update_info(reader.png, reader.info);
        if (png_get_rowbytes(reader.png, reader.info) != pixel_bytes * layout.width)
          png_error(reader.png, "unexpected pixel layout");
        png_read_image(reader.png, const_cast<png_bytepp>(rows.data()));
        png_read_end(reader.png, reader.info);
        png_get_text(reader.png, reader.info, &texts, &text_count);
      }))
    fail(name, stream, "cannot be read as PNG", read_hint);
  Image image = to_image(layout, pixels);
  for (int i = 0; i < text_count; ++i) image.metadata[texts[i].key] = texts[i].text;
  return image;
}

}  // namespace penumbra
