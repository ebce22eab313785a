// SPDX-License-Identifier: MIT
// What commands that write files share.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace penumbra {

/// "out/map.png" and "-light0": "out/map-light0.png".
std::string with_suffix(const std::string& path, std::string_view suffix);

/// File names say enough; the folders are the user's own business.
std::string without_folders(const std::string& argument);

/// A command line for metadata, without folders.
std::string command_text(const std::vector<std::string>& arguments);

}  // namespace penumbra
