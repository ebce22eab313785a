// SPDX-License-Identifier: MIT
// Short ways to say in C what tests say often.
#pragma once

#include <cstdint>
#include <vector>

#include "penumbra/penumbra_c.h"
#include "tests/visibility/callers_arrays.h"

namespace penumbra {

template <class Row>
penumbra_rows c_rows(const std::vector<Row>& rows) {
  return {rows.data(), rows.size(), 0};
}

inline penumbra_rows c_positions(const CallersArrays& arrays) {
  return {arrays.vertices.data(), arrays.vertices.size(), sizeof(Vertex)};
}

inline penumbra_light c_light(std::uint32_t kind) {
  penumbra_light light{};
  light.struct_size = sizeof light;
  light.kind = kind;
  light.center[0] = 1, light.center[1] = 6, light.center[2] = 0.5f;
  light.u[0] = 1, light.u[1] = 0.25f, light.v[2] = 0.75f;
  light.radius = 0.75f;
  light.diameter_deg = 5;
  return light;
}

/// The light that most tests ask about.
inline penumbra_light c_ball() { return c_light(PENUMBRA_LIGHT_BALL); }

inline penumbra_points c_points(const CallersArrays& arrays) {
  penumbra_points points{};
  points.struct_size = sizeof points;
  points.positions = c_rows(arrays.points);
  points.normals = c_rows(arrays.normals);
  return points;
}

inline penumbra_ask_options c_options(std::uint32_t shadow_samples = 32) {
  penumbra_ask_options options;
  penumbra_default_ask_options(&options, sizeof options);
  options.shadow_samples = shadow_samples;
  return options;
}

/// Occluders that are released when the test ends.
class CScene {
 public:
  CScene() { penumbra_create(&handle_); }
  ~CScene() { penumbra_release(handle_); }
  CScene(const CScene&) = delete;
  CScene& operator=(const CScene&) = delete;
  operator penumbra_occluders() const { return handle_; }  // NOLINT: as C passes it

 private:
  penumbra_occluders handle_{};
};

}  // namespace penumbra
