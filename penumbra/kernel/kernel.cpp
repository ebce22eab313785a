// SPDX-License-Identifier: MIT
#include "penumbra/kernel/kernel.h"
