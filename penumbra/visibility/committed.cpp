// SPDX-License-Identifier: MIT
#include "penumbra/visibility/committed.h"

#include <utility>

namespace penumbra {

std::shared_ptr<const Committed> build(GatheredShapes gathered) {
  auto made = std::make_shared<Committed>(Kernel(gathered.shapes, {}), std::move(gathered.names));
  made->shadows = prepare_shadows(made->kernel, gathered.shapes, {}, {}, Method::shaft);
  return made;
}

std::shared_ptr<const Committed> refitted(const Committed& before, GatheredShapes& gathered) {
  if (!(before.names == gathered.names)) return {};
  auto moved = std::make_shared<Committed>(before.kernel.refitted(gathered.shapes),
                                           std::move(gathered.names));
  moved->shadows = with_moved_shapes(before.shadows, moved->kernel, gathered.shapes);
  return moved;
}

}  // namespace penumbra
