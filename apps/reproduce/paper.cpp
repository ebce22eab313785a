// SPDX-License-Identifier: MIT
#include "paper.h"

namespace penumbra::reproduce {

const std::array<PaperScene, 5> paper_scenes{{
    {"Cylinders", 11, 12.05, 5.22, 1'027'757, 287'481, {}, {}, 2.1},
    {"Balls4", 7'383, 64.21, 25.39, 1'397'529, 213'120, 51'719, 10'976, {}},
    {"Rings", 62, 32.35, 10.54, 1'459'345, 215'155, 47'415, 2'962, {}},
    {"Molecule", 1'685, 8.25, 4.95, 105'153, 26'691, {}, {}, 2.7},
    {"Bust", 98'506, 37.47, 24.02, 496'704, 135'324, 32'136, 0, 1.8},
}};

const std::array<PaperLight, 4> paper_lights{{
    {"1/54", 1.0 / 54, 7.83},
    {"1/18", 1.0 / 18, {}},
    {"1/6", 1.0 / 6, {}},
    {"1/2", 1.0 / 2, 1.76},
}};

}  // namespace penumbra::reproduce
