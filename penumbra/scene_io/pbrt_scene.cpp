// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/pbrt_scene.h"

#include <cmath>

#include <fmt/format.h>

#include "penumbra/scene_io/numbers.h"

namespace penumbra {

void warn_unread(PbrtScene& pbrt, std::string_view directive, const PbrtDefinition& definition) {
  constexpr std::size_t most_kinds = 50;
  for (const PbrtParameter* parameter : definition.params.unread()) {
    std::string kind = fmt::format("parameter {} of {} {} is not read", in_quotes(parameter->name),
                                   directive, in_quotes(definition.kind));
    if (pbrt.unread.size() == most_kinds && !pbrt.unread.contains(kind))
      kind = "further parameters are not read";
    else
      pbrt.unread.insert(kind);
    pbrt.warnings.add(kind, parameter->place);
  }
}

bool is_pbrt_interface(std::string_view kind) {
  return kind.empty() || kind == "interface" || kind == "none";
}

ShapeSet& pbrt_target(PbrtScene& pbrt) {
  ShapeSet& shapes = pbrt.scene.shapes;
  return pbrt.open_group ? shapes.groups[*pbrt.open_group] : shapes;
}

}  // namespace penumbra
