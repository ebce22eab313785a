// SPDX-License-Identifier: MIT
// Views as Radiance's rvu and rpict take them: options such as `-vtv -vp 0 -5 1 -vd 0 1 0`, view
// files, and the headers of pictures.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "penumbra/scene/camera.h"

namespace penumbra {

struct RadianceView {
  Camera camera;
  std::string warning;  ///< what is not done; empty: nothing
};

/// The words of an option `--view`: view options (-vt -vp -vd -vu -vh -vv -vo -va -vs -vl, and -vf
/// for a file, found beside `beside`), or else the name of a view file. What is not given is as in
/// Radiance: from the origin along y, z up, 45 degrees each way. Throws Error.
RadianceView parse_radiance_view(std::string_view text, const std::filesystem::path& beside = {});

/// The view of a file: of all its lines that begin with a program's name (rvu, rview, rpict, ...),
/// with VIEW= or with an option, taken one after the other, each changing the last. Other lines,
/// and what no view option is, are read past. Throws Error with the line, and for files without any
/// view.
RadianceView read_radiance_view(const std::filesystem::path& file);

}  // namespace penumbra
