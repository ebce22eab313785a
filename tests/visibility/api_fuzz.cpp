// SPDX-License-Identifier: MIT
// api_fuzz [SECONDS [SEED]]: random calls of the C API, first of one thread, whose answers are
// compared, then of several at once, for as long as it is given. What comes to no defined code is
// printed with the seed that repeats it (SECONDS 0); all else is for the sanitizers to see.
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

#include "tests/visibility/api_calls.h"

namespace penumbra::fuzz {
namespace {

/// One pool of handles. False at the first call that went wrong.
bool round(std::uint64_t seed, Tally& tally) {
  constexpr std::uint32_t thread_count = 4, calls = 200;
  Random random(seed);
  Arrays arrays(random);
  Pool pool;
  Caller alone(pool, arrays, seed, true);
  for (std::uint32_t i = 0; i < calls; ++i)
    if (!alone.call()) return false;
  tally.add(alone.tally());

  std::vector<Caller> callers;
  for (std::uint32_t t = 0; t < thread_count; ++t)
    callers.emplace_back(pool, arrays, (seed << 8) + t + 1, false);
  std::atomic<bool> is_good = true;
  std::vector<std::thread> threads;
  for (Caller& caller : callers)
    threads.emplace_back([&caller, &is_good] {
      for (std::uint32_t i = 0; i < calls / thread_count && is_good; ++i)
        if (!caller.call()) is_good = false;
    });
  for (std::thread& thread : threads) thread.join();
  for (const Caller& caller : callers) tally.add(caller.tally());

  // What they left behind is whole.
  for (std::uint32_t i = 0; i < calls / 8 && is_good; ++i)
    if (!alone.call()) return false;
  return is_good;
}

}  // namespace
}  // namespace penumbra::fuzz

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 10;
  std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  const auto start = std::chrono::steady_clock::now();
  penumbra::fuzz::Tally tally;
  do {
    if (!penumbra::fuzz::round(seed++, tally)) {
      std::fprintf(stderr, "seed %llu\n", static_cast<unsigned long long>(seed - 1));
      return 1;
    }
  } while (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() <
           seconds);
  const auto number = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
  std::printf("%llu calls, %llu without error, %llu out of memory\n", number(tally.calls),
              number(tally.fine), number(tally.out_of_memory));
  std::printf("%llu commits, %llu refits, %llu points compared\n", number(tally.commits),
              number(tally.refits), number(tally.compared));
  return 0;
}
