// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <system_error>
#include <utility>

#include "penumbra/scene/error.h"

namespace penumbra {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
  if (path == "-")
    throw Error({}, std::string("cannot write to the standard output: ") + std::strerror(error));
  throw Error({path.string(), {}, {}}, std::string("cannot be written: ") + std::strerror(error),
              "check the folder, its permissions and the space left");
}

/// Opens a file beside `path` that did not exist, and gives its name.
int open_beside(const std::filesystem::path& path, std::filesystem::path& name) {
  static std::atomic<std::uint32_t> counter = 0;
  for (int attempt = 0; attempt < 100; ++attempt) {
    name = path;
    name.replace_filename(".penumbra-" + std::to_string(getpid()) + "-" +
                          std::to_string(counter++) + ".part");
    const int file = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file >= 0 || errno != EEXIST) return file;
  }
  return -1;
}

}  // namespace

OutputFile::OutputFile(const std::filesystem::path& path) : path_(path) {
  if (path == "-") {
    file_ = STDOUT_FILENO;
    return;
  }
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(path, ignored);
  if (std::filesystem::is_directory(status)) fail(path, EISDIR);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    file_ = open(path.c_str(), O_WRONLY | O_CLOEXEC);
    require(file_ >= 0);
    return;
  }
  // The target of a link is replaced, not the link.
  target_ = std::filesystem::canonical(path, ignored);
  if (target_.empty()) target_ = path;
  std::filesystem::path name;
  file_ = open_beside(target_, name);
  require(file_ >= 0);
  temporary_ = name;
}

OutputFile::~OutputFile() {
  if (file_ > STDOUT_FILENO) close(file_);
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

void OutputFile::require(bool is_good) {
  if (!is_good) fail(path_, errno);
}

void OutputFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file_, bytes.data(), bytes.size());
    require(written >= 0 || errno == EINTR);
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void OutputFile::rewrite_start(std::string_view bytes) {
  require(lseek(file_, 0, SEEK_SET) == 0);
  write(bytes);
}

void OutputFile::finish() {
  if (file_ > STDOUT_FILENO) require(close(std::exchange(file_, -1)) == 0);
  if (temporary_.empty()) return;
  require(rename(temporary_.c_str(), target_.c_str()) == 0);
  temporary_.clear();
}

}  // namespace penumbra
