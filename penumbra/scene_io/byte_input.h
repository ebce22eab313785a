// SPDX-License-Identifier: MIT
// Bytes as they come, from a file, a pipe or memory: unzipped, and never all of them at once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "penumbra/scene_io/gunzip.h"

namespace penumbra {

/// detect_gzip: what begins as gzip does is unpacked. none: bytes are taken as they are.
enum class Packing { detect_gzip, none };

class ByteInput {
 public:
  /// A file or pipe; `-` is the standard input. Throws Error for what cannot be read.
  ByteInput(const std::filesystem::path& path, Packing packing);
  /// Bytes in memory, as if they were a file of this name.
  ByteInput(std::string name, std::string bytes);
  ByteInput(const ByteInput&) = delete;
  ByteInput& operator=(const ByteInput&) = delete;

  /// What comes next: at least `least` bytes unless the input ends before, and no more than have
  /// come already. Valid until the next call. Throws Error where reading fails. Memory: `least`
  /// and 1 MiB.
  std::string_view peek(std::size_t least = 1) {
    while (end_ - begin_ < least && !has_ended_) fill();
    return {buffer_.data() + begin_, end_ - begin_};
  }
  /// Goes on behind `count` bytes that `peek` gave.
  void skip(std::size_t count) { begin_ += count; }

  /// How many bytes were skipped.
  std::uint64_t at() const { return before_ + begin_; }
  /// In messages.
  const std::string& name() const { return name_; }
  /// Bytes that are left, where that is known: in memory, and in files that are not packed.
  std::optional<std::uint64_t> remaining() const;
  /// Share of a file that was read, in [0, 1]; nothing for pipes.
  std::optional<double> share() const;

 private:
  struct Descriptor {
    int number = -1;
    ~Descriptor();
  };

  void fill();
  std::size_t read_some(char* room, std::size_t size);
  std::size_t unpack_some(char* room, std::size_t size);

  std::string name_;
  Descriptor file_;
  std::optional<std::uint64_t> size_;  ///< of the file
  std::uint64_t read_ = 0;             ///< bytes of the file
  std::string buffer_;
  std::size_t begin_ = 0, end_ = 0;  ///< of what is not skipped, in the buffer
  std::uint64_t before_ = 0;         ///< bytes that have left the buffer
  bool has_ended_ = false;
  std::optional<Gunzip> gunzip_;
  std::string packed_;
  std::size_t packed_begin_ = 0;
  bool is_packed_end_ = false;
};

}  // namespace penumbra
