// SPDX-License-Identifier: MIT
#include "machine.h"

#include <fmt/format.h>
#include <zlib.h>

#include <fstream>
#include <thread>
#include <vector>

#include "penumbra/kernel/embree_baseline.h"
#include "penumbra/kernel/traverse.h"
#include "penumbra/version.h"

namespace penumbra {
namespace {

std::string cpu_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

std::string program_checksum() {
  std::ifstream file("/proc/self/exe", std::ios::binary);
  std::vector<char> bytes(1 << 16);
  uLong sum = crc32(0, nullptr, 0);
  while (file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())) || file.gcount() > 0) {
    const auto count = static_cast<uInt>(file.gcount());
    sum = crc32(sum, reinterpret_cast<const Bytef*>(bytes.data()), count);
  }
  return fmt::format("{:08x}", sum);
}

}  // namespace

Machine this_machine() {
  return {cpu_name(),        std::thread::hardware_concurrency(),
          instruction_set(), embree_version(),
          PENUMBRA_VERSION,  PENUMBRA_COMPILER,
          PENUMBRA_FLAGS,    program_checksum()};
}

std::string to_text(const Machine& m) {
  return fmt::format("{}, {} cores, {}; Embree {}; penumbra {}", m.cpu, m.cores, m.instruction_set,
                     m.embree, m.version);
}

}  // namespace penumbra
