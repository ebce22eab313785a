// SPDX-License-Identifier: MIT
// The whole of penumbra's visibility queries: see visibility/occluders.h.
#pragma once

#include "penumbra/scene/error.h"
#include "penumbra/visibility/lights.h"
#include "penumbra/visibility/occluders.h"
