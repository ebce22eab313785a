// SPDX-License-Identifier: MIT
// What measurements were made with: no figure without it.
#pragma once

#include <string>

namespace penumbra {

struct Machine {
  std::string cpu, cores, instruction_set, embree, version, compiler, flags;
  friend bool operator==(const Machine&, const Machine&) = default;
};

/// Of this program's file (CRC-32, in hexadecimal): tells builds of one version apart.
std::string program_checksum();

/// This program on this machine.
Machine this_machine();

/// "AMD EPYC, 2 cores, AVX3; Embree 3.13.5; penumbra 0.1.0"
std::string to_text(const Machine& machine);

}  // namespace penumbra
