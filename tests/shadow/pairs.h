// SPDX-License-Identifier: MIT
// Suites of tests that run once for every pair of shape and light.
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <tuple>

#include "tests/shadow/light_kinds.h"
#include "tests/shadow/shape_forms.h"

namespace penumbra {

inline void PrintTo(const ShapeForm& form, std::ostream* out) { *out << form.name; }

using Pair = std::tuple<ShapeForm, const char*>;

inline std::string name_of_pair(const testing::TestParamInfo<Pair>& info) {
  return std::string(std::get<ShapeForm>(info.param).name) + "_under_" +
         std::get<const char*>(info.param);
}

class EveryPair : public testing::TestWithParam<Pair> {
 protected:
  ShapeForm form() const { return std::get<ShapeForm>(GetParam()); }
  const char* light_kind() const { return std::get<const char*>(GetParam()); }
};

inline auto every_pair() {
  return testing::Combine(testing::ValuesIn(shape_forms), testing::ValuesIn(light_kinds));
}

}  // namespace penumbra
