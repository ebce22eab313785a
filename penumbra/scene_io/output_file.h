// SPDX-License-Identifier: MIT
// A file that is written bit by bit, and is there whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace penumbra {

/// Everything throws Error, naming the file, where it cannot be written.
class OutputFile {
 public:
  /// `-` is the standard output. Others are written under a temporary name beside `path`, but for
  /// pipes and devices, which cannot be replaced by a rename, and must not be.
  explicit OutputFile(const std::filesystem::path& path);
  /// Takes away what was not finished.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// At once, without a buffer.
  void write(std::string_view bytes);
  /// Overwrites the beginning. Not for pipes and devices.
  void rewrite_start(std::string_view bytes);
  /// Gives the file its name.
  void finish();

  /// Under which it is written until then; empty for the standard output, pipes and devices.
  const std::filesystem::path& temporary() const { return temporary_; }

 private:
  void require(bool is_good);

  std::filesystem::path path_, target_, temporary_;
  int file_ = -1;
};

}  // namespace penumbra
