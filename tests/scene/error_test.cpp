// SPDX-License-Identifier: MIT
#include "penumbra/scene/error.h"

#include <string>

#include <gtest/gtest.h>

namespace penumbra {
namespace {

TEST(Error, SaysWhereWhatAndWhatToDo) {
  EXPECT_EQ(Error({"a.nff", 12, {}}, "unknown keyword", "remove it").what(),
            std::string("a.nff:12: unknown keyword; remove it"));
  EXPECT_EQ(Error({"a.stl", {}, 84}, "ends here").what(), std::string("a.stl: byte 84: ends here"));
  EXPECT_EQ(Error({}, "nothing to draw").what(), std::string("nothing to draw"));
}

}  // namespace
}  // namespace penumbra
