// SPDX-License-Identifier: MIT
// The paper's Tables 1 to 4, ours beside its figures.
#pragma once

#include "report.h"
#include "results.h"

namespace penumbra::reproduce {

Table run_times(const Results& results);      ///< Table 1
Table building(const Results& results);       ///< what Table 1 leaves out
Table rays_traced(const Results& results);    ///< Table 2, objects, lights and rays
Table tests_per_ray(const Results& results);  ///< Table 2, I_geom and I_shadow
Table memory_taken(const Results& results);   ///< Table 3
Table light_sizes(const Results& results);    ///< Table 4

}  // namespace penumbra::reproduce
