// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/image_io.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "penumbra/scene/error.h"
#include "penumbra/scene_io/image_formats.h"
#include "penumbra/scene_io/source.h"
#include "penumbra/scene_io/write_scene.h"

namespace penumbra {
namespace {

enum class Format { png, exr };

Format format_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".png") return Format::png;
  if (extension == ".exr") return Format::exr;
  throw Error({path.string(), {}, {}}, "not a picture format that is known here",
              "use a name that ends in .png or .exr");
}

}  // namespace

void write_image(const std::filesystem::path& path, const Image& image, float exposure_ev) {
  write_file(path, format_of(path) == Format::png ? to_png(path, image, exposure_ev)
                                                  : to_exr(path, image));
}

void write_grey_image(const std::filesystem::path& path, const Image& image,
                      const GreyCoding& coding) {
  write_file(path, to_grey_png(path, image, coding));
}

void check_image_path(const std::filesystem::path& path) {
  format_of(path);
  check_output_path(path);
}

void check_output_path(const std::filesystem::path& path) {
  if (path.filename().empty() || std::filesystem::is_directory(path))
    throw Error({path.string(), {}, {}}, "is a folder", "give the name of a file");
  // Pipes and devices are written to where they are.
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(path, ignored);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) return;
  // Permission bits say little (root, read-only and full disks), so try it.
  std::filesystem::path probe = path;
  probe += fmt::format(".{}.probe", ::getpid());
  const int file = ::open(probe.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (file < 0)
    throw Error({path.string(), {}, {}},
                fmt::format("cannot be written ({})", std::strerror(errno)),
                "choose a folder that exists and that you may write to");
  ::close(file);
  ::unlink(probe.c_str());
}

void check_picture_size(const std::filesystem::path& name, std::uint64_t width,
                        std::uint64_t height, std::uint64_t bytes_per_pixel, std::uint64_t stored) {
  constexpr std::uint64_t most_pixels = std::uint64_t{1} << 28;
  if (width == 0 || height == 0)
    throw Error({name.string(), {}, {}}, fmt::format("a picture of {}x{} pixels", width, height),
                "the file is damaged; make it again");
  if (width > most_pixels || height > most_pixels / width)
    throw Error({name.string(), {}, {}},
                fmt::format("a picture of {}x{} pixels is too large", width, height),
                "at most 2^28 pixels can be read");
  // Deflate packs at most 1032:1, the other codecs not much more; the constant lets small files be.
  constexpr std::uint64_t most_packed = 4096, small = std::uint64_t{1} << 24;
  if (width * height > (stored * most_packed + small) / std::max<std::uint64_t>(1, bytes_per_pixel))
    throw Error(
        {name.string(), {}, {}},
        fmt::format("claims {}x{} pixels, which {} bytes cannot hold", width, height, stored),
        "the file is damaged or cut short; make it again");
}

std::vector<std::uint8_t> srgb_codes(const std::filesystem::path& name, const Image& image,
                                     float exposure_ev) {
  const std::size_t count = std::size_t{image.width} * image.height;
  const float scale = std::exp2(exposure_ev);
  std::vector<std::uint8_t> codes(3 * count);
  int color = 0;
  for (const char* channel_name : {"R", "G", "B"}) {
    const Channel* channel = find_channel(image, channel_name);
    if (!channel || channel->values.size() != count)
      throw Error({name.string(), {}, {}}, "a PNG or JPEG needs the channels R, G and B",
                  "write these as .exr");
    for (std::size_t i = 0; i < count; ++i)
      codes[3 * i + color] = srgb_from_linear(channel->values[i] * scale);
    ++color;
  }
  return codes;
}

Image read_image(const std::filesystem::path& path) {
  const Format format = format_of(path);
  const Source source = load(path);
  return format == Format::png ? from_png(path, source.bytes) : from_exr(path, source.bytes);
}

}  // namespace penumbra
