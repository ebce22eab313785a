// SPDX-License-Identifier: MIT
// A format that is fuzzed: its corpus, and how bytes of it are read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace penumbra {

struct FuzzFormat {
  std::string name;  ///< also the extension, and the folder of its corpus
  std::filesystem::path folder;
  std::vector<std::filesystem::path> paths;  ///< files of this extension, in order of their names
  std::vector<std::string> samples;          ///< their bytes
};

/// `corpus` holds a folder a format; what other files are in it is for those to refer to. Throws
/// std::runtime_error where there are none.
FuzzFormat load_format(const std::filesystem::path& corpus, const std::string& name);

/// Names of all formats of a corpus, sorted.
std::vector<std::string> format_names(const std::filesystem::path& corpus);

/// The input of a seed: a damaged sample.
std::string input_of(const FuzzFormat& format, std::uint64_t seed);

/// What became of an input.
enum class Outcome { scene, error };

/// Reads bytes as if they were a file in the format's folder, to a validated scene. Anything but
/// a scene or Error, with a message of sensible length, is thrown on.
Outcome read_input(const FuzzFormat& format, std::string bytes);

}  // namespace penumbra
