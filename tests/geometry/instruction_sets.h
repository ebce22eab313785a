// SPDX-License-Identifier: MIT
// The instruction sets that the code was built for and this processor has, one after the other.
#pragma once

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstdint>

namespace penumbra {

/// What is dispatched goes to these of Highway's targets, while this lives.
struct HeldToTargets {
  explicit HeldToTargets(std::int64_t targets) { set(targets); }
  HeldToTargets(const HeldToTargets&) = delete;
  HeldToTargets& operator=(const HeldToTargets&) = delete;
  ~HeldToTargets() { set(0); }  // all that the processor has

  static void set(std::int64_t targets) {
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
};

/// Calls f() under each instruction set; what fails in it is said with the set's name.
template <class F>
void for_each_instruction_set(F&& f) {
  for (std::int64_t rest = hwy::SupportedTargets() & HWY_TARGETS; rest != 0; rest &= rest - 1) {
    const std::int64_t target = rest & -rest;
    SCOPED_TRACE(hwy::TargetName(target));
    const HeldToTargets held(target);
    f();
  }
}

}  // namespace penumbra
