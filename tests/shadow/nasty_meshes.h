// SPDX-License-Identifier: MIT
// Meshes with and without an inside, squeezed, turned, sheared and holed at random.
#pragma once

#include "tests/geometry/solid_meshes.h"
#include "tests/kernel/nasty_shapes.h"

namespace penumbra::nasty {

inline Mesh random_mesh(Random& random) {
  using namespace solid_meshes;
  const std::uint32_t rows = 3 + random.below(12);
  switch (random.below(9)) {
    case 0: return box();
    case 1: return torus(3 + random.below(20), 3 + random.below(12));
    case 2: return crossed_torus(3 + random.below(20), 8);
    case 3: return globe(rows, random.uniform(0, 0.6f), random.below(4));
    case 4: return corner_piece();
    case 5: return joined(box(), placed(globe(6), 0.7f, random.in_cube()));
    case 6: return moebius_strip(4 + random.below(20));
    default: return globe(rows, random.uniform(0, 0.6f));
  }
}

/// May have no triangle left.
inline Mesh nasty_mesh(const Place& place, Random& random) {
  Mesh mesh = random_mesh(random);
  const Vec3f x = random.one_in(2) ? Vec3f{1, 0, 0} : random.in_cube();
  const Vec3f y = random.one_in(2) ? Vec3f{0, 1, 0} : random.in_cube();
  const Vec3f z{random.uniform(-1, 1), 0, random.power(-3, 0)};
  const Vec3f middle = random.in_cube();
  for (Vec3f& p : mesh.positions) p = place(middle + x * p.x + y * p.y + z * p.z);
  for (std::uint32_t i = random.below(6); i > 3; --i)
    mesh.triangles.erase(mesh.triangles.begin() +
                         random.below(static_cast<std::uint32_t>(mesh.triangles.size())));
  drop_degenerate_triangles(mesh);
  return mesh;
}

}  // namespace penumbra::nasty
