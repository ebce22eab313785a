// SPDX-License-Identifier: MIT
// The PLY format (Greg Turk, 1994): what its header says, and how values are read by it.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "penumbra/scene/scene.h"
#include "penumbra/scene_io/source.h"
#include "penumbra/scene_io/tokens.h"

namespace penumbra {

enum class PlyFormat { ascii, binary_little_endian, binary_big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t size_in_bytes(PlyType type);
bool is_integer(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> count_type;  ///< of a list; none: a single value
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
  std::size_t line = 1;  ///< in the header
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  Vec3d up{0, 1, 0};      ///< y, unless a comment `up x y z` says otherwise
  std::size_t size = 0;   ///< bytes up to the first value
  std::size_t lines = 0;  ///< of the header
};

/// A value of a binary format from the bytes at `bytes`.
double ply_value(const char* bytes, PlyType type, PlyFormat format);

/// Throws Error with the line.
PlyHeader read_ply_header(const Source& source);

/// The values behind a header, one after the other. Copies are bookmarks.
class PlyBody {
 public:
  /// The source must outlive it.
  PlyBody(const Source& source, const PlyHeader& header);

  // The next value; throws Error where there is none, `integer` also where it is not a whole
  // number.
  double real(PlyType type);
  std::int64_t integer(PlyType type);
  /// Skips all rows of an element.
  void skip(const PlyElement& element);
  void skip_value(const PlyProperty& property);
  /// Length of the list that follows; its values are known to fit into the bytes that are left.
  std::size_t list_length(const PlyProperty& property);
  /// Throws Error where the element claims more rows than the bytes that are left can hold.
  void check_count(const PlyElement& element) const;
  /// Where the last value stands: its line, or its first byte.
  Error::Place place() const;

 private:
  std::size_t remaining() const;
  std::size_t least_bytes(PlyType type) const;
  std::string_view take(std::size_t count);

  PlyFormat format_;
  std::string file_;
  std::string_view bytes_;  ///< the whole file, so that offsets are the file's
  std::size_t at_ = 0, last_ = 0;
  Tokens tokens_;
};

/// Triangle meshes as binary PLY, colours as 8-bit sRGB; backdrops stay out unless they are all
/// there is. Throws Error naming `file` for a scene with other shapes.
std::string to_ply(const Scene& scene, const std::string& file);

}  // namespace penumbra
