// SPDX-License-Identifier: MIT
#include "penumbra/trace/render.h"
