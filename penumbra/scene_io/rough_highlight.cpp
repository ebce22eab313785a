// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/rough_highlight.h"

#include <algorithm>

namespace penumbra {

void set_rough_highlight(Material& material, Color specular, double alpha) {
  material.shininess =
      static_cast<float>(std::clamp(2 / std::max(alpha * alpha, 1e-6) - 2, 1.0, 2000.0));
  const float height = std::min((material.shininess + 2) / 2, 8.0f);
  material.highlight = min(specular * height, Color{1, 1, 1});
}

}  // namespace penumbra
