// SPDX-License-Identifier: MIT
#include "penumbra/shadow/visibility.h"
