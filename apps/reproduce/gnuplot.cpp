// SPDX-License-Identifier: MIT
#include "gnuplot.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "penumbra/scene/error.h"

namespace penumbra::reproduce {
namespace {

[[noreturn]] void fail(const std::string& why, const std::string& hint) {
  throw Error({"gnuplot", {}, {}}, why, hint);
}

constexpr const char* system_hint = "is the machine out of memory or of processes?";
constexpr const char* install_hint = "install it: apt-get install gnuplot-nox";

/// A file in memory that nobody else sees: unlike pipes, these three need no reading and writing in
/// turns.
class MemoryFile {
 public:
  MemoryFile() : file_(memfd_create("gnuplot", MFD_CLOEXEC)) {
    if (file_ < 0) fail(fmt::format("cannot be started ({})", std::strerror(errno)), system_hint);
  }
  ~MemoryFile() { close(file_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  int descriptor() const { return file_; }

  /// Then whoever reads starts at the beginning.
  void fill(const std::string& bytes) const {
    for (std::size_t at = 0; at < bytes.size();) {
      const ssize_t written = write(file_, bytes.data() + at, bytes.size() - at);
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) fail("cannot be given its script", system_hint);
      at += static_cast<std::size_t>(written);
    }
    lseek(file_, 0, SEEK_SET);
  }

  std::string bytes() const {
    std::string all;
    std::array<char, 1 << 14> buffer;
    lseek(file_, 0, SEEK_SET);
    while (true) {
      const ssize_t got = read(file_, buffer.data(), buffer.size());
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) return all;
      all.append(buffer.data(), static_cast<std::size_t>(got));
    }
  }

 private:
  int file_;
};

/// posix_spawn's list of what happens to descriptors, freed however its use ends.
struct Redirections {
  Redirections(const MemoryFile& in, const MemoryFile& out, const MemoryFile& err) {
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, in.descriptor(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, out.descriptor(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, err.descriptor(), STDERR_FILENO);
  }
  ~Redirections() { posix_spawn_file_actions_destroy(&actions); }
  Redirections(const Redirections&) = delete;
  Redirections& operator=(const Redirections&) = delete;
  posix_spawn_file_actions_t actions;
};

pid_t start(const Redirections& redirections) {
  std::string name = "gnuplot", no_settings = "-d", from_input = "-";
  std::array<char*, 4> arguments = {name.data(), no_settings.data(), from_input.data(), nullptr};
  pid_t child = 0;
  const int error =
      posix_spawnp(&child, name.c_str(), &redirections.actions, nullptr, arguments.data(), environ);
  if (error == ENOENT) fail("is not on this machine; it draws the plots", install_hint);
  if (error != 0) fail(fmt::format("cannot be started ({})", std::strerror(error)), install_hint);
  return child;
}

/// gnuplot shows the line that it does not like, then a mark beneath, then why.
std::string one_line(const std::string& text) {
  std::string line;
  for (char c : text) {
    const char next = c == '\n' ? ' ' : c;
    if (next != ' ' || (!line.empty() && line.back() != ' ')) line += next;
  }
  while (line.ends_with(' ')) line.pop_back();
  return line;
}

}  // namespace

std::string run_gnuplot(const std::string& script) {
  const MemoryFile in, out, err;
  in.fill(script);
  const pid_t child = start(Redirections(in, out, err));
  int status = 0;
  pid_t ended = -1;
  do ended = waitpid(child, &status, 0);
  while (ended < 0 && errno == EINTR);
  if (ended != child || !WIFEXITED(status) || WEXITSTATUS(status) != 0)
    fail(fmt::format("failed ({})", one_line(err.bytes())), "is it gnuplot 5.4 or later?");
  return out.bytes();
}

void check_gnuplot() { run_gnuplot("if (GPVAL_VERSION < 5.4) exit status 1\n"); }

}  // namespace penumbra::reproduce
