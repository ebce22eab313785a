// SPDX-License-Identifier: MIT
// scene_io_fuzz FORMAT SECONDS [SEED [CORPUS]]: damaged files through a reader, for as long as it
// is given. An input must end in a scene or an Error, within 5 seconds of processor time and
// 1 GiB of memory. One that doesn't is saved, and the seed named that repeats it alone (SECONDS 0).
// scene_io_fuzz FORMAT FILE reads one file so.
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <new>
#include <sstream>
#include <string>

#include "tests/scene_io/fuzz/fuzz_format.h"

namespace {

using penumbra::FuzzFormat;
using penumbra::Outcome;

constexpr int most_seconds = 5;
constexpr long most_megabytes = 1024;

/// What the worker tells the one who waits for it, in memory that both see.
struct Progress {
  std::uint64_t seed = 0, inputs = 0, scenes = 0;
};

void limit_time() {
  itimerval limit{};
  limit.it_value.tv_sec = most_seconds;
  setitimer(ITIMER_PROF, &limit, nullptr);
}

/// Far beyond what an input may take, so that one that takes all there is harms nobody. Not under
/// the sanitizer, which reserves terabytes and has a limit of its own.
void limit_memory() {
#if !defined(__SANITIZE_ADDRESS__)
  constexpr rlimit limit{rlim_t{4} << 30, rlim_t{4} << 30};
  setrlimit(RLIMIT_AS, &limit);
#endif
}

/// The most this process had.
long megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

/// True where all is well.
bool try_input(const FuzzFormat& format, std::string bytes, Progress& progress) {
  limit_time();
  try {
    if (penumbra::read_input(format, std::move(bytes)) == Outcome::scene) ++progress.scenes;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "neither a scene nor an Error: %s\n", error.what());
    return false;
  }
  ++progress.inputs;
  if (megabytes() <= most_megabytes) return true;
  std::fprintf(stderr, "took %ld MiB\n", megabytes());
  return false;
}

int work(const FuzzFormat& format, double seconds, std::uint64_t seed, Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  do {
    progress.seed = seed;
    if (!try_input(format, penumbra::input_of(format, seed++), progress)) return 1;
  } while (elapsed() < seconds);
  return 0;
}

/// In a process of its own; returns what `waitpid` says of it.
template <typename Work>
int run_apart(Work work_apart) {
  const pid_t worker = fork();
  if (worker == 0) {
    limit_memory();
    std::exit(work_apart());
  }
  int status = 0;
  waitpid(worker, &status, 0);
  return status;
}

std::string reason(int status) {
  if (WIFEXITED(status)) return "exit code " + std::to_string(WEXITSTATUS(status));
  const int sent = WTERMSIG(status);
  if (sent == SIGPROF) return "more than " + std::to_string(most_seconds) + " s";
  return "signal " + std::to_string(sent) + " (" + strsignal(sent) + ")";
}

int fuzz(const FuzzFormat& format, double seconds, std::uint64_t seed, const char* program) {
  void* shared =
      mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) throw std::bad_alloc();
  Progress& progress = *new (shared) Progress;
  const int status = run_apart([&] { return work(format, seconds, seed, progress); });
  std::printf("%s: %llu inputs, %llu of them scenes\n", format.name.c_str(),
              static_cast<unsigned long long>(progress.inputs),
              static_cast<unsigned long long>(progress.scenes));
  if (status == 0) return 0;
  const auto bad = static_cast<unsigned long long>(progress.seed);
  const std::string file = "fuzz-" + std::to_string(bad) + "." + format.name;
  std::ofstream(file, std::ios::binary) << penumbra::input_of(format, progress.seed);
  std::fprintf(stderr, "%s: seed %llu: %s; the input is in %s. Repeat it with\n  %s %s 0 %llu %s\n",
               format.name.c_str(), bad, reason(status).c_str(), file.c_str(), program,
               format.name.c_str(), bad, format.folder.parent_path().c_str());
  return 1;
}

int read_file(const FuzzFormat& format, const char* file, const char* program) {
  std::ostringstream bytes;
  bytes << std::ifstream(file, std::ios::binary).rdbuf();
  Progress progress;
  const int status = run_apart([&] { return try_input(format, bytes.str(), progress) ? 0 : 1; });
  if (status == 0) return 0;
  std::fprintf(stderr, "%s %s %s: %s\n", program, format.name.c_str(), file,
               reason(status).c_str());
  return 1;
}

}  // namespace

#if defined(__SANITIZE_ADDRESS__)
// What the sanitizer keeps for itself must not count.
extern "C" const char* __asan_default_options() {
  return "quarantine_size_mb=4:max_allocation_size_mb=1024:hard_rss_limit_mb=2048";
}
#endif

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: %s FORMAT SECONDS|FILE [SEED [CORPUS]]\n", argv[0]);
    return 2;
  }
  const std::string corpus = argc > 4 ? argv[4] : PENUMBRA_SOURCE_DIR "/tests/scene_io/corpus";
  char* end = nullptr;
  const double seconds = std::strtod(argv[2], &end);
  const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  try {
    const FuzzFormat format = penumbra::load_format(corpus, argv[1]);
    if (*end != '\0') return read_file(format, argv[2], argv[0]);
    return fuzz(format, seconds, seed, argv[0]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
