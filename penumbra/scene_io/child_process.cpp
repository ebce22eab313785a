// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>

#include <fmt/format.h>

namespace penumbra {

namespace {

constexpr int exit_out_of_memory = 3, exit_exception = 4;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool has_shadow_memory = true;  // sanitizers map terabytes: no limit would let them live
#else
constexpr bool has_shadow_memory = false;
#endif

void limit(decltype(RLIMIT_AS) resource, std::size_t value) {
  rlimit r{};
  getrlimit(resource, &r);
  r.rlim_cur = std::min<rlim_t>(value, r.rlim_max);
  setrlimit(resource, &r);
}

/// Address space in use, in bytes; 0 where /proc does not say.
std::size_t address_space() {
  std::size_t pages = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%zu", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

void write_all(int file, const std::string& bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t written = write(file, bytes.data() + at, bytes.size() - at);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) _exit(exit_exception);
    at += static_cast<std::size_t>(written);
  }
}

[[noreturn]] void be_child(const std::function<std::string()>& work, const ChildLimits& limits,
                           int output) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (!has_shadow_memory) limit(RLIMIT_AS, address_space() + limits.memory_bytes);
  limit(RLIMIT_CPU, limits.cpu_seconds);
  limit(RLIMIT_CORE, 0);
  const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
  for (int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
  // Handlers of the program would run its own clean-up here.
  for (int number : {SIGINT, SIGTERM, SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL})
    std::signal(number, SIG_DFL);
  try {
    write_all(output, work());
  } catch (const std::bad_alloc&) {
    _exit(exit_out_of_memory);
  } catch (...) {
    _exit(exit_exception);
  }
  _exit(0);
}

/// Reads until the child closes its end. Empty, or why it did not come to that.
std::string read_output(int input, const ChildLimits& limits, std::string& output) {
  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + std::chrono::seconds(limits.wall_seconds);
  std::array<char, 1 << 16> buffer;
  while (true) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) return fmt::format("it took longer than {} seconds", limits.wall_seconds);
    pollfd waiting{input, POLLIN, 0};
    if (poll(&waiting, 1, static_cast<int>(std::min<long long>(left, 1 << 30))) <= 0) continue;
    const ssize_t got = read(input, buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return {};
    output.append(buffer.data(), static_cast<std::size_t>(got));
    if (output.size() > limits.output_bytes)
      return fmt::format("it made more than {} MiB of the file", limits.output_bytes >> 20);
  }
}

std::string failure_of(int status, const ChildLimits& limits) {
  if (WIFSIGNALED(status)) {
    const int number = WTERMSIG(status);
    if (number == SIGXCPU || number == SIGKILL)
      return fmt::format("it took longer than {} seconds", limits.cpu_seconds);
    return fmt::format("it crashed (signal {})", number);
  }
  if (WEXITSTATUS(status) == 0) return {};
  if (WEXITSTATUS(status) == exit_out_of_memory)
    return fmt::format("it wanted more than {} MiB of memory", limits.memory_bytes >> 20);
  return "it failed";
}

}  // namespace

ChildResult run_in_child(const std::function<std::string()>& work, const ChildLimits& limits) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return {{}, "there are no pipes left"};
  const pid_t child = fork();
  if (child < 0) {
    close(ends[0]), close(ends[1]);
    return {{}, fmt::format("no process could be started: {}", std::strerror(errno))};
  }
  if (child == 0) {
    close(ends[0]);
    be_child(work, limits, ends[1]);
  }
  close(ends[1]);
  ChildResult result;
  result.failure = read_output(ends[0], limits, result.output);
  close(ends[0]);
  if (!result.failure.empty()) kill(child, SIGKILL);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (result.failure.empty()) result.failure = failure_of(status, limits);
  if (!result.failure.empty()) result.output.clear();
  return result;
}

}  // namespace penumbra
