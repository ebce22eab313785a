// SPDX-License-Identifier: MIT
// A file's bytes, unzipped, with limits, for the readers; and what each reader is called with.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "penumbra/scene/error.h"
#include "penumbra/scene/scene.h"
#include "penumbra/scene_io/read_scene.h"

namespace penumbra {

/// Whole contents of a file and the name it has in messages.
struct Source {
  std::filesystem::path path;  ///< as given, for messages and for files beside it
  std::string extension;       ///< lower case, without dot and without a final .gz
  std::string bytes;           ///< decompressed
};

/// Reads and, where the content is gzip whatever the name, unpacks. Throws Error for files that
/// cannot be read, directories, broken gzip, and more than 8 GiB of content (2 GiB of it unpacked
/// from gzip).
Source load(const std::filesystem::path& path);

/// Throws Error for all but regular files and pipes: devices and folders have no end, or no bytes.
void check_readable(const std::filesystem::path& path);

/// Warnings by kind: the first of each kind is kept with its line, the others are counted. Kinds
/// may quote a file: they are cut after 300 bytes, and from the 51st on they are one kind.
class Warnings {
 public:
  explicit Warnings(std::string file) : file_(std::move(file)) {}
  /// `kind` is the text that makes two warnings the same; line 0: none known.
  void add(std::string_view kind, std::size_t line = 0);
  /// The same for what stands in another file, or may do so.
  void add(std::string_view kind, const Error::Place& place);
  /// "file:line: kind (and N more)"
  std::vector<std::string> lines() const;

 private:
  struct Entry {
    std::string kind;
    Error::Place place;
    std::size_t count = 0;
  };
  bool knows(std::string_view kind) const;

  std::string file_;
  std::vector<Entry> entries_;
};

/// What `read_scene` does with a file once it is loaded.
SceneFile read_source(Source source, const ReadOptions& options);

// The readers: bytes in, a scene out, not yet validated. All throw Error with line or byte.
Scene read_nff(const Source& source, Warnings& warnings);
Scene read_obj(const Source& source, Warnings& warnings);
Scene read_ply(const Source& source, Warnings& warnings);
Scene read_stl(const Source& source, Warnings& warnings);
Scene read_radiance(const Source& source, Warnings& warnings);
Scene read_gltf(const Source& source, Warnings& warnings);
Scene read_pbrt(const Source& source, Warnings& warnings);
Scene read_molecule(const Source& source, const ReadOptions& options, Warnings& warnings);
Scene read_assimp(const Source& source, Warnings& warnings);

}  // namespace penumbra
