// SPDX-License-Identifier: MIT
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "penumbra/scene/error.h"
#include "penumbra/scene_io/image_formats.h"

namespace penumbra {
namespace {

/// OpenEXR's file, kept in memory: writing a picture is then one `write_file`, for every format.
class MemoryOut : public Imf::OStream {
 public:
  explicit MemoryOut(const std::string& name) : OStream(name.c_str()) {}
  void write(const char from[], int count) override {
    const std::size_t size = static_cast<std::size_t>(count);
    if (bytes.size() < position_ + size) bytes.resize(position_ + size);
    std::memcpy(bytes.data() + position_, from, size);
    position_ += size;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }
  std::string bytes;

 private:
  std::size_t position_ = 0;
};

class MemoryIn : public Imf::IStream {
 public:
  MemoryIn(const std::string& name, std::string_view bytes)
      : IStream(name.c_str()), bytes_(bytes) {}
  bool read(char to[], int count) override {
    if (count < 0 || position_ > bytes_.size() ||
        static_cast<std::size_t>(count) > bytes_.size() - position_)
      throw std::runtime_error("the file ends too early");
    std::memcpy(to, bytes_.data() + position_, static_cast<std::size_t>(count));
    position_ += static_cast<std::size_t>(count);
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  std::string_view bytes_;
  std::size_t position_ = 0;
};

Imf::Header header_of(const Image& image) {
  Imf::Header header(static_cast<int>(image.width), static_cast<int>(image.height));
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const Channel& channel : image.channels)
    header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
  for (const auto& [key, value] : image.metadata) header.insert(key, Imf::StringAttribute(value));
  return header;
}

void add_strings(const Imf::Header& header, Image& image) {
  for (auto i = header.begin(); i != header.end(); ++i)
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&i.attribute()))
      image.metadata[i.name()] = text->value();
}

/// The header's picture with channels of zeros. Throws where the header makes no sense.
Image empty_image(const std::filesystem::path& name, const Imf::Header& header,
                  std::size_t stored) {
  const auto window = header.dataWindow();
  const auto extent = [](int lo, int hi) {
    return static_cast<std::uint64_t>(std::max<std::int64_t>(0, std::int64_t{hi} - lo + 1));
  };
  const std::uint64_t width = extent(window.min.x, window.max.x),
                      height = extent(window.min.y, window.max.y);
  std::vector<std::string> names;
  for (auto i = header.channels().begin(); i != header.channels().end(); ++i) {
    if (i.channel().xSampling != 1 || i.channel().ySampling != 1)
      throw std::runtime_error(fmt::format("channel {} has its own resolution", i.name()));
    names.push_back(i.name());
  }
  check_picture_size(name, width, height, sizeof(float) * names.size(), stored);
  Image image{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), {}, {}};
  for (const std::string& channel : names)
    image.channels.push_back({channel, std::vector<float>(width * height)});
  return image;
}

/// Throws where an attribute of the header claims more bytes than there are: OpenEXR would allocate
/// them. Layout: magic, version and flags, then name\0 type\0 size value, and \0 at the end.
void check_attributes(std::string_view bytes) {
  constexpr std::size_t preamble = 8;
  std::size_t at = preamble;
  while (at < bytes.size() && bytes[at] != '\0') {
    const std::size_t name_end = bytes.find('\0', at);
    const std::size_t type_end =
        name_end == bytes.npos ? bytes.npos : bytes.find('\0', name_end + 1);
    if (type_end == bytes.npos || bytes.size() - type_end <= sizeof(std::int32_t)) break;
    std::int32_t size = 0;  // little endian, as the machines we run on
    std::memcpy(&size, bytes.data() + type_end + 1, sizeof size);
    at = type_end + 1 + sizeof size;
    if (size < 0 || static_cast<std::size_t>(size) > bytes.size() - at) break;
    at += static_cast<std::size_t>(size);
  }
  if (at >= bytes.size() || bytes[at] != '\0')
    throw std::runtime_error("the header ends too early");
}

/// The header's picture with channels of zeros, before OpenEXR allocates anything by the header.
Image picture_claimed(const std::filesystem::path& name, std::string_view bytes) {
  std::uint32_t preamble[2] = {0, 0};
  std::memcpy(preamble, bytes.data(), std::min(bytes.size(), sizeof preamble));
  constexpr std::uint32_t magic = 20000630, multipart_or_deep = 0x1800;
  if (preamble[0] != magic) throw std::runtime_error("its first bytes are not those of OpenEXR");
  if (preamble[1] & multipart_or_deep)
    throw std::runtime_error("it has several parts or deep pixels, only one flat picture is read");
  check_attributes(bytes);
  MemoryIn stream(name.string(), bytes);
  stream.seekg(sizeof preamble);
  Imf::Header header;
  int version = static_cast<int>(preamble[1]);
  header.readFrom(stream, version);
  return empty_image(name, header, bytes.size());
}

Image read_all(const std::filesystem::path& name, std::string_view bytes) {
  constexpr int largest_tile = 1024;
  Imf::Header::setMaxTileSize(largest_tile, largest_tile);
  Image image = picture_claimed(name, bytes);
  MemoryIn stream(name.string(), bytes);
  Imf::InputFile file(stream);
  const auto window = file.header().dataWindow();
  Imf::FrameBuffer frame;
  for (Channel& channel : image.channels)
    frame.insert(channel.name, Imf::Slice::Make(Imf::FLOAT, channel.values.data(), window));
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);
  add_strings(file.header(), image);
  return image;
}

}  // namespace

std::string to_exr(const std::filesystem::path& name, const Image& image) {
  try {
    MemoryOut stream(name.string());
    {
      const Imf::Header header = header_of(image);
      Imf::OutputFile file(stream, header);
      Imf::FrameBuffer frame;
      for (const Channel& channel : image.channels)
        frame.insert(channel.name,
                     Imf::Slice::Make(Imf::FLOAT, channel.values.data(), header.dataWindow()));
      file.setFrameBuffer(frame);
      file.writePixels(static_cast<int>(image.height));
    }  // the file's end is written when it is closed
    return std::move(stream.bytes);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw Error({name.string(), {}, {}},
                fmt::format("cannot be written as OpenEXR ({})", error.what()), "write it as .png");
  }
}

Image from_exr(const std::filesystem::path& name, std::string_view bytes) {
  try {
    return read_all(name, bytes);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    throw Error({name.string(), {}, {}},
                fmt::format("cannot be read as OpenEXR ({})", error.what()),
                "is it an OpenEXR file, and whole? Make or copy it again");
  }
}

}  // namespace penumbra
