// SPDX-License-Identifier: MIT
#include "penumbra/geometry/shape.h"

#include <gtest/gtest.h>

namespace penumbra {
namespace {

TEST(Shape, BoxOfATiltedConeTouchesItsCircles) {
  const Cone cone{{0, 0, 0}, {1, 0, 0}, 2, 1};
  const Box box = bounds(cone);
  EXPECT_FLOAT_EQ(box.lo.x, 0);
  EXPECT_FLOAT_EQ(box.hi.x, 1);
  EXPECT_FLOAT_EQ(box.lo.y, -2);
  EXPECT_FLOAT_EQ(box.hi.z, 2);
}

}  // namespace
}  // namespace penumbra
