// SPDX-License-Identifier: MIT
// The parts of a glTF 2.0 file that all others refer to: JSON, buffers, views, accessors.
// Read through nlohmann::json: tinygltf reads past the end of damaged files (a binary chunk's
// header and an image's buffer view are taken as given) and recurses as deep as the file says.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "penumbra/scene_io/source.h"

namespace penumbra {

using Json = nlohmann::json;

/// Bytes of a buffer and where they lie, for messages.
struct GltfBuffer {
  std::string owned;           ///< of an external or embedded buffer
  std::string_view in_source;  ///< of the binary chunk, or of a buffer of the same file
  std::string file;
  std::size_t offset_in_file = 0;

  std::string_view bytes() const { return owned.empty() ? in_source : std::string_view(owned); }
};

struct GltfDocument {
  const Source& source;
  Json root;
  std::vector<GltfBuffer> buffers;
  /// How many numbers may still be read from accessors, by the size of the file: one array of a
  /// small one can be used a million times.
  std::size_t numbers_left = 0;

  /// Throws Error that names the file.
  [[noreturn]] void fail(std::string what, std::string hint = "export the file again") const;
};

/// Parses .gltf or .glb (by content) and loads all buffers; external ones are looked for beside the
/// file. Throws Error with line or byte for what is no JSON, with the buffer's name where one is
/// missing or too short, and for required extensions as `check_required_extensions`.
GltfDocument open_gltf(const Source& source, Warnings& warnings);

// JSON as glTF uses it. Each throws Error where a value is there but of the wrong kind.
const Json* member(const Json& object, const char* key);      ///< nullptr where there is none
const Json* extension(const Json& object, const char* name);  ///< in its "extensions"
std::size_t element_count(const GltfDocument& gltf, const char* list);
/// list[index] of the root, which must be there.
const Json& element(const GltfDocument& gltf, const char* list, std::size_t index);
std::optional<std::size_t> index_of(const GltfDocument& gltf, const Json& object, const char* key);
double number_of(const GltfDocument& gltf, const Json& object, const char* key, double otherwise);
std::string string_of(const GltfDocument& gltf, const Json& object, const char* key);
/// An array of exactly this many numbers; nothing where the key is absent.
std::optional<std::vector<double>> numbers_of(const GltfDocument& gltf, const Json& object,
                                              const char* key, std::size_t count);
/// A list of indices; empty where the key is absent.
std::vector<std::size_t> indices_of(const GltfDocument& gltf, const Json& object, const char* key);

/// The bytes of a buffer view, checked to lie in its buffer.
struct GltfView {
  std::string_view bytes;
  std::size_t stride = 0;  ///< 0: packed
  std::size_t buffer = 0, offset = 0;
};
GltfView buffer_view(const GltfDocument& gltf, std::size_t index);

/// The bytes that a URI stands for: data or a file beside ours; nothing where there is no such
/// file.
std::optional<std::string> uri_bytes(const GltfDocument& gltf, std::string_view uri);

}  // namespace penumbra
