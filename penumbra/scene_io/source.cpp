// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/source.h"
