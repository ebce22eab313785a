// SPDX-License-Identifier: MIT
// Files that are there whole or not at all.
#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <system_error>

#include "penumbra/scene/error.h"
#include "penumbra/scene_io/write_scene.h"

namespace penumbra {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
  throw Error({path.string(), {}, {}}, std::string("cannot be written: ") + std::strerror(error),
              "check the folder, its permissions and the space left");
}

/// Writes everything; 0 or an errno. Closes the file in any case.
int write_and_close(int file, std::string_view bytes) {
  int error = 0;
  while (!bytes.empty() && error == 0) {
    const ssize_t written = write(file, bytes.data(), bytes.size());
    if (written >= 0)
      bytes.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EINTR)
      error = errno;
  }
  if (close(file) != 0 && error == 0) error = errno;
  return error;
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

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(path, ignored);
  if (std::filesystem::is_directory(status)) fail(path, EISDIR);
  // Pipes and devices cannot be replaced by a rename, and must not be.
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    const int file = open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (file < 0) fail(path, errno);
    if (const int error = write_and_close(file, bytes); error != 0) fail(path, error);
    return;
  }
  // The target of a link is replaced, not the link.
  std::filesystem::path target = std::filesystem::canonical(path, ignored);
  if (target.empty()) target = path;
  std::filesystem::path name;
  const int file = open_beside(target, name);
  if (file < 0) fail(path, errno);
  int error = write_and_close(file, bytes);
  if (error == 0 && rename(name.c_str(), target.c_str()) != 0) error = errno;
  if (error == 0) return;
  unlink(name.c_str());
  fail(path, error);
}

}  // namespace penumbra
