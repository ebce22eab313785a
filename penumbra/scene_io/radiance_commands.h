// SPDX-License-Identifier: MIT
// The commands of Radiance scene files that are carried out here, none of them by running anything:
// `xform` (placements of files), `cat` and `genbox`, also piped into `xform`.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "penumbra/geometry/transform.h"
#include "penumbra/scene/error.h"
#include "penumbra/scene_io/radiance_file.h"

namespace penumbra {

/// The programs of a pipe, each as its words. Throws Error at `place` for what needs a shell.
std::vector<std::vector<std::string>> split_radiance_command(std::string_view command,
                                                             const Error::Place& place);

/// Throws Error: nothing but the above is carried out, and what to do instead.
[[noreturn]] void refuse_radiance_command(std::string_view program, const Error::Place& place);

/// What an `xform` does to what it reads.
struct RadianceXform {
  std::vector<Transform> placements;  ///< one, but for -a and -f
  std::string modifier;               ///< -m; empty: none
  bool is_inverted = false;           ///< -I
  std::vector<std::string> files;     ///< empty: standard input
};

/// Returns the text of the file that -f names.
using RadianceTextReader = std::function<std::string(const std::string& name)>;

/// The options as xform's manual page has them: transformations in their order; -i n repeats those
/// after it up to the next -i or -a; -a n is -i 0 to -i n - 1, one after the other; -f takes the
/// place of each line of a file in turn. Throws Error at `place` for what it does not know and for
/// more than `most` placements.
RadianceXform parse_radiance_xform(const std::vector<std::string>& words, std::size_t most,
                                   const RadianceTextReader& read_text, const Error::Place& place);

/// What `genbox` prints for these words: polygons, with rounded edges (-r) cylinders and spheres.
/// Throws Error at `place`.
RadianceFile radiance_box(const std::vector<std::string>& words, const Error::Place& place);

}  // namespace penumbra
