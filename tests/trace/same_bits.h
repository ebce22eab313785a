// SPDX-License-Identifier: MIT
// Whether two pictures are equal, NaN and signs of zero included.
#pragma once

#include <cstring>

#include "penumbra/scene/image.h"

namespace penumbra {

inline bool same_bits(const Image& a, const Image& b) {
  if (a.channels.size() != b.channels.size()) return false;
  for (std::size_t i = 0; i < a.channels.size(); ++i)
    if (a.channels[i].name != b.channels[i].name ||
        a.channels[i].values.size() != b.channels[i].values.size() ||
        std::memcmp(a.channels[i].values.data(), b.channels[i].values.data(),
                    a.channels[i].values.size() * sizeof(float)) != 0)
      return false;
  return true;
}

}  // namespace penumbra
