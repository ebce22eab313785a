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

Image read_all(const std::filesystem::path& name, std::string_view bytes) {
  // Checked while the header is read, before the table of lines is allocated.
  constexpr int largest_side = 1 << 20;
  Imf::Header::setMaxImageSize(largest_side, largest_side);
  MemoryIn stream(name.string(), bytes);
  Imf::InputFile file(stream);
  const auto window = file.header().dataWindow();
  Image image = empty_image(name, file.header(), bytes.size());
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
