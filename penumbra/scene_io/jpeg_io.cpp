// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/jpeg_io.h"

#include <array>
#include <csetjmp>
#include <cstdio>
#include <cstdlib>

#include <jpeglib.h>

#include "penumbra/scene/error.h"
#include "penumbra/scene_io/image_formats.h"

namespace penumbra {

namespace {

/// Each scan goes through the whole picture, whatever little it has to say.
constexpr int most_scans = 100;

/// libjpeg's state with our way out: its errors jump.
struct Decoder {
  jpeg_decompress_struct info{};
  jpeg_error_mgr errors{};
  jpeg_progress_mgr progress{};
  std::jmp_buf exit{};
};

Decoder& decoder_of(j_common_ptr info) { return *static_cast<Decoder*>(info->client_data); }

void prepare(Decoder& decoder, std::string_view bytes) {
  decoder.info.err = jpeg_std_error(&decoder.errors);
  decoder.errors.error_exit = [](j_common_ptr info) { std::longjmp(decoder_of(info).exit, 1); };
  decoder.errors.output_message = [](j_common_ptr) {};
  decoder.progress.progress_monitor = [](j_common_ptr info) {
    if (reinterpret_cast<j_decompress_ptr>(info)->input_scan_number > most_scans)
      std::longjmp(decoder_of(info).exit, 1);
  };
  jpeg_create_decompress(&decoder.info);
  decoder.info.client_data = &decoder;
  decoder.info.progress = &decoder.progress;
  jpeg_mem_src(&decoder.info, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
}

/// False where libjpeg gives up. Nothing with a destructor lives here, since jumps run none.
bool read_header(Decoder& decoder) {
  if (setjmp(decoder.exit) != 0) return false;
  if (jpeg_read_header(&decoder.info, TRUE) != JPEG_HEADER_OK) return false;
  decoder.info.out_color_space = JCS_RGB;
  return true;
}

bool read_rows(Decoder& decoder, std::uint8_t* codes) {
  if (setjmp(decoder.exit) != 0) return false;
  jpeg_start_decompress(&decoder.info);
  while (decoder.info.output_scanline < decoder.info.output_height) {
    const std::size_t row = decoder.info.output_scanline;
    JSAMPROW target = codes + row * decoder.info.output_width * 3;
    jpeg_read_scanlines(&decoder.info, &target, 1);
  }
  return true;
}

/// The same for writing. libjpeg allocates a buffer, and sets `bytes` to it at the end alone.
struct Encoder {
  jpeg_compress_struct info{};
  jpeg_error_mgr errors{};
  std::jmp_buf exit{};
  std::array<char, JMSG_LENGTH_MAX> message{};
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
};

void prepare(Encoder& encoder) {
  encoder.info.err = jpeg_std_error(&encoder.errors);
  encoder.info.client_data = &encoder;
  encoder.errors.error_exit = [](j_common_ptr info) {
    Encoder& failed = *static_cast<Encoder*>(info->client_data);
    info->err->format_message(info, failed.message.data());
    std::longjmp(failed.exit, 1);
  };
  encoder.errors.output_message = [](j_common_ptr) {};
}

void describe(Encoder& encoder, const Image& image, int quality) {
  jpeg_create_compress(&encoder.info);
  encoder.info.client_data = &encoder;
  jpeg_mem_dest(&encoder.info, &encoder.bytes, &encoder.size);
  encoder.info.image_width = image.width;
  encoder.info.image_height = image.height;
  encoder.info.input_components = 3;
  encoder.info.in_color_space = JCS_RGB;
  jpeg_set_defaults(&encoder.info);
  jpeg_set_quality(&encoder.info, quality, TRUE);
  encoder.info.optimize_coding = TRUE;
  encoder.info.comp_info[0].h_samp_factor = encoder.info.comp_info[0].v_samp_factor = 1;
}

/// False where libjpeg gives up. Nothing with a destructor lives here, since jumps run none.
bool write_rows(Encoder& encoder, const Image& image, std::uint8_t* codes, int quality) {
  if (setjmp(encoder.exit) != 0) return false;
  describe(encoder, image, quality);
  jpeg_start_compress(&encoder.info, TRUE);
  while (encoder.info.next_scanline < encoder.info.image_height) {
    JSAMPROW source = codes + std::size_t{encoder.info.next_scanline} * image.width * 3;
    jpeg_write_scanlines(&encoder.info, &source, 1);
  }
  jpeg_finish_compress(&encoder.info);
  return true;
}

}  // namespace

bool is_jpeg(std::string_view bytes) { return bytes.starts_with("\xFF\xD8\xFF"); }

JpegImage decode_jpeg(std::string_view bytes, std::size_t most_pixels) {
  Decoder decoder;
  prepare(decoder, bytes);
  JpegImage image;
  const bool has_header = read_header(decoder);
  const std::size_t width = decoder.info.image_width, height = decoder.info.image_height;
  if (has_header && height > 0 && width <= most_pixels / height) {
    image.codes.resize(width * height * 3);
    if (read_rows(decoder, image.codes.data())) {
      image.width = decoder.info.image_width;
      image.height = decoder.info.image_height;
    } else {
      image.codes.clear();
    }
  }
  jpeg_destroy_decompress(&decoder.info);
  return image;
}

std::string encode_jpeg(const Image& image, int quality, float exposure_ev) {
  std::vector<std::uint8_t> codes = srgb_codes({}, image, exposure_ev);
  Encoder encoder;
  prepare(encoder);
  const bool is_written = write_rows(encoder, image, codes.data(), quality);
  std::string bytes;
  if (is_written) bytes.assign(reinterpret_cast<const char*>(encoder.bytes), encoder.size);
  if (!is_written && encoder.info.dest) encoder.info.dest->term_destination(&encoder.info);
  jpeg_destroy_compress(&encoder.info);
  std::free(encoder.bytes);
  if (!is_written)
    throw Error({}, std::string("cannot be written as JPEG (") + encoder.message.data() + ")",
                "write it as .png");
  return bytes;
}

}  // namespace penumbra
