// SPDX-License-Identifier: MIT
// The visibility component alone: a square under a ball light, and what points below it see.
#include <penumbra/penumbra.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <vector>

int main() {
  const std::vector<penumbra::Vec3f> corners = {{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}};
  const std::vector<std::array<std::uint32_t, 3>> triangles = {{0, 1, 2}, {0, 2, 3}};
  penumbra::Occluders occluders;
  occluders.add_triangles(corners, triangles);
  occluders.commit();

  const penumbra::BallLight light{{0, 9, 0}, 0.5f};
  const std::vector<penumbra::Vec3f> points = {{0, 0, 0}, {1.1f, 0, 0}, {5, 0, 0}};
  const penumbra::Points asking{.positions = points};
  const std::vector<penumbra::ShadowClass> classes = occluders.classify(asking, light);
  const std::vector<float> seen = occluders.visible_fraction(asking, light);
  for (std::size_t i = 0; i < points.size(); ++i)
    std::printf("%d %g\n", static_cast<int>(classes[i]), seen[i]);

  // Errors cross the library's border.
  try {
    penumbra::polygon_light({corners.data(), 2});
  } catch (const penumbra::Error& error) {
    std::printf("refused: %s\n", error.what());
  }
}
