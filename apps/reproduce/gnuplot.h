// SPDX-License-Identifier: MIT
// gnuplot as a child process, without a shell and without files.
#pragma once

#include <string>

namespace penumbra::reproduce {

/// What gnuplot writes to its output for this script, with settings of users and machine left out.
/// Throws Error where it is missing (and says which package to install) or fails (with its words).
std::string run_gnuplot(const std::string& script);

/// Throws Error unless gnuplot can be run: call it before an hour of measuring.
void check_gnuplot();

}  // namespace penumbra::reproduce
