// SPDX-License-Identifier: MIT
// Memory that runs out when a test wants it to.
#pragma once

#include <cstdint>

namespace penumbra {

/// While it lives, `operator new` fails in this thread, once, after it was called `calls` times.
class FailingNew {
 public:
  explicit FailingNew(std::uint32_t calls);
  ~FailingNew();
  FailingNew(const FailingNew&) = delete;
  FailingNew& operator=(const FailingNew&) = delete;
};

}  // namespace penumbra
