// SPDX-License-Identifier: MIT
#include "machine.h"

#include <fmt/format.h>

#include <fstream>
#include <thread>

#include "penumbra/kernel/embree_baseline.h"
#include "penumbra/kernel/traverse.h"

namespace penumbra {
namespace {

std::string cpu_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

}  // namespace

Machine this_machine() {
  return {cpu_name(),        std::to_string(std::thread::hardware_concurrency()),
          instruction_set(), embree_version(),
          PENUMBRA_VERSION,  PENUMBRA_COMPILER,
          PENUMBRA_FLAGS};
}

std::string to_text(const Machine& m) {
  return fmt::format("{}, {} cores, {}; Embree {}; penumbra {}", m.cpu, m.cores, m.instruction_set,
                     m.embree, m.version);
}

}  // namespace penumbra
