// SPDX-License-Identifier: MIT
#include "penumbra/trace/names.h"

namespace penumbra {

const char* name_of(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::sphere: return "sphere";
    case ShapeKind::cone: return "cone";
    case ShapeKind::ring: return "ring";
    case ShapeKind::triangle: break;
  }
  return "triangle";
}

const char* name_of(ShadowClass shadow_class) {
  switch (shadow_class) {
    case ShadowClass::lit: return "lit";
    case ShadowClass::penumbra: return "penumbra";
    case ShadowClass::umbra: break;
  }
  return "umbra";
}

std::string path_name(std::uint64_t path) {
  if (path <= 1) return "camera ray";
  return path_name(path / 2) + (path % 2 == 0 ? " > reflected" : " > refracted");
}

}  // namespace penumbra
