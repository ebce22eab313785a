// SPDX-License-Identifier: MIT
// What measurements were made with: no figure without it.
#pragma once

#include <string>

namespace penumbra {

struct Machine {
  std::string cpu;
  unsigned cores = 1;
  std::string instruction_set, embree, version, compiler, flags;
  std::string program;  ///< CRC-32 of the program's file: tells builds of one version apart
};

/// This program on this machine. Reads the program's file.
Machine this_machine();

/// "AMD EPYC, 2 cores, AVX3; Embree 3.13.5; penumbra 0.1.0"
std::string to_text(const Machine& machine);

}  // namespace penumbra
