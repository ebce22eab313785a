// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/gltf_document.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "penumbra/scene_io/gltf_extensions.h"
#include "penumbra/scene_io/gltf_uri.h"
#include "penumbra/scene_io/texture_io.h"

namespace penumbra {

namespace {

/// A GLB file's two chunks; `json_offset` is 0 where the file is JSON alone.
struct Chunks {
  std::string_view json, binary;
  std::size_t json_offset = 0, binary_offset = 0;
};

std::uint32_t u32_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i)
    value = value << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]);
  return value;
}

[[noreturn]] void fail_at(const Source& source, std::size_t byte, std::string what) {
  throw Error({source.path.string(), {}, byte}, std::move(what), "is the file damaged or cut off?");
}

Chunks split_glb(const Source& source) {
  const std::string_view bytes = source.bytes;
  if (!bytes.starts_with("glTF")) return {bytes, {}, 0, 0};
  constexpr std::uint32_t json_type = 0x4E4F534A, binary_type = 0x004E4942;
  if (bytes.size() < 20) fail_at(source, bytes.size(), "the file ends in its header");
  if (u32_at(bytes, 4) != 2)
    throw Error({source.path.string(), {}, 4}, fmt::format("glTF version {}", u32_at(bytes, 4)),
                "convert it to version 2");
  Chunks chunks;
  for (std::size_t at = 12; at + 8 <= bytes.size();) {
    const std::size_t size = u32_at(bytes, at);
    const std::uint32_t type = u32_at(bytes, at + 4);
    if (size > bytes.size() - at - 8)
      fail_at(source, at,
              fmt::format("a chunk of {} bytes, but {} are left", size, bytes.size() - at - 8));
    if (at == 12 && type != json_type) fail_at(source, at, "the first chunk is not JSON");
    if (type == json_type && chunks.json_offset == 0) {
      chunks.json = bytes.substr(at + 8, size);
      chunks.json_offset = at + 8;
    } else if (type == binary_type && chunks.binary_offset == 0) {
      chunks.binary = bytes.substr(at + 8, size);
      chunks.binary_offset = at + 8;
    }
    at += 8 + size;
  }
  return chunks;
}

Json parse_json(const Source& source, const Chunks& chunks) {
  try {
    return Json::parse(chunks.json.begin(), chunks.json.end());
  } catch (const Json::parse_error& error) {
    const std::size_t at = std::min(error.byte > 0 ? error.byte - 1 : 0, chunks.json.size());
    if (chunks.json_offset > 0) fail_at(source, chunks.json_offset + at, "broken JSON");
    const std::string_view before = chunks.json.substr(0, at);
    const auto line = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1;
    throw Error({source.path.string(), line, {}}, "broken JSON", "is the file damaged or cut off?");
  } catch (const Json::exception& error) {  // a number beyond the range of double
    throw Error({source.path.string(), {}, {}}, fmt::format("broken JSON: {:.200}", error.what()),
                "is the file damaged?");
  }
}

/// A buffer beside the file, loaded once, however many names it goes by. `gltf.buffers` must not
/// move meanwhile.
GltfBuffer load_file(const GltfDocument& gltf, const std::string& uri,
                     std::map<std::string, std::size_t>& loaded) {
  const auto path = find_beside(gltf.source.path, decode_uri(uri));
  if (!path)
    gltf.fail(fmt::format("the buffer '{:.100}' is missing", uri), "put it beside the file");
  GltfBuffer buffer;
  buffer.file = decode_uri(uri);
  const auto [known, is_new] = loaded.try_emplace(file_key(*path), gltf.buffers.size());
  if (is_new)
    buffer.owned = load(*path).bytes;
  else
    buffer.in_source = gltf.buffers[known->second].bytes();
  return buffer;
}

void load_buffers(GltfDocument& gltf, const Chunks& chunks) {
  const std::size_t count = element_count(gltf, "buffers");
  gltf.buffers.reserve(count);
  std::map<std::string, std::size_t> loaded;
  for (std::size_t i = 0; i < count; ++i) {
    const Json& json = element(gltf, "buffers", i);
    const std::string uri = string_of(gltf, json, "uri");
    GltfBuffer buffer;
    buffer.file = gltf.source.path.string();
    if (is_data_uri(uri)) {
      buffer.owned = *uri_bytes(gltf, uri);
    } else if (!uri.empty()) {
      buffer = load_file(gltf, uri, loaded);
    } else if (i == 0) {
      buffer.in_source = chunks.binary;
      buffer.offset_in_file = chunks.binary_offset;
    }
    const auto claimed = index_of(gltf, json, "byteLength").value_or(0);
    if (claimed > buffer.bytes().size())
      gltf.fail(
          fmt::format("buffer {} claims {} bytes, but has {}", i, claimed, buffer.bytes().size()),
          "is the file damaged or cut off?");
    gltf.buffers.push_back(std::move(buffer));
  }
}

/// A JSON number that counts or indexes something; doubles that are whole will do.
std::size_t to_index(const GltfDocument& gltf, const Json& json, const char* key) {
  const double value = json.is_number() ? json.get<double>() : -1;
  if (!(value >= 0 && value < 0x1p53) || std::floor(value) != value)
    gltf.fail(fmt::format("'{}' is not a whole number from 0 up", key));
  return static_cast<std::size_t>(value);
}

}  // namespace

void GltfDocument::fail(std::string what, std::string hint) const {
  throw Error({source.path.string(), {}, {}}, std::move(what), std::move(hint));
}

GltfDocument open_gltf(const Source& source, Warnings& warnings) {
  const Chunks chunks = split_glb(source);
  GltfDocument gltf{source, parse_json(source, chunks), {}};
  const Json* asset = member(gltf.root, "asset");
  if (!asset) gltf.fail("there is no 'asset', so it is no glTF 2.0 file", "is it some other JSON?");
  if (const std::string version = string_of(gltf, *asset, "version"); !version.starts_with("2"))
    gltf.fail(fmt::format("glTF version '{:.10}'", version), "convert it to version 2");
  check_required_extensions(gltf, warnings);
  load_buffers(gltf, chunks);
  std::size_t bytes = source.bytes.size();
  for (const GltfBuffer& buffer : gltf.buffers) bytes += buffer.owned.size();
  gltf.numbers_left = std::min(std::size_t{1} << 29, (std::size_t{1} << 24) + 32 * bytes);
  return gltf;
}

const Json* member(const Json& object, const char* key) {
  if (!object.is_object()) return nullptr;
  const auto at = object.find(key);
  return at == object.end() ? nullptr : &*at;
}

const Json* extension(const Json& object, const char* name) {
  const Json* extensions = member(object, "extensions");
  return extensions ? member(*extensions, name) : nullptr;
}

std::size_t element_count(const GltfDocument& gltf, const char* list) {
  const Json* json = member(gltf.root, list);
  if (!json) return 0;
  if (!json->is_array()) gltf.fail(fmt::format("'{}' is not a list", list));
  return json->size();
}

const Json& element(const GltfDocument& gltf, const char* list, std::size_t index) {
  const std::size_t count = element_count(gltf, list);
  if (index >= count)
    gltf.fail(
        fmt::format("something refers to number {} of '{}', which has {}", index, list, count));
  return (*member(gltf.root, list))[index];
}

std::optional<std::size_t> index_of(const GltfDocument& gltf, const Json& object, const char* key) {
  const Json* json = member(object, key);
  if (!json) return std::nullopt;
  return to_index(gltf, *json, key);
}

double number_of(const GltfDocument& gltf, const Json& object, const char* key, double otherwise) {
  const Json* json = member(object, key);
  if (!json) return otherwise;
  if (!json->is_number()) gltf.fail(fmt::format("'{}' is not a number", key));
  return json->get<double>();
}

std::string string_of(const GltfDocument& gltf, const Json& object, const char* key) {
  const Json* json = member(object, key);
  if (!json) return {};
  if (!json->is_string()) gltf.fail(fmt::format("'{}' is not text", key));
  return json->get<std::string>();
}

std::optional<std::vector<double>> numbers_of(const GltfDocument& gltf, const Json& object,
                                              const char* key, std::size_t count) {
  const Json* json = member(object, key);
  if (!json) return std::nullopt;
  const bool fits = json->is_array() && json->size() == count &&
                    std::all_of(json->begin(), json->end(),
                                [](const Json& number) { return number.is_number(); });
  if (!fits) gltf.fail(fmt::format("'{}' is not a list of {} numbers", key, count));
  return json->get<std::vector<double>>();
}

std::vector<std::size_t> indices_of(const GltfDocument& gltf, const Json& object, const char* key) {
  const Json* json = member(object, key);
  if (!json) return {};
  if (!json->is_array()) gltf.fail(fmt::format("'{}' is not a list", key));
  std::vector<std::size_t> indices;
  for (const Json& entry : *json) indices.push_back(to_index(gltf, entry, key));
  return indices;
}

GltfView buffer_view(const GltfDocument& gltf, std::size_t index) {
  const Json& json = element(gltf, "bufferViews", index);
  for (const char* packed : {"EXT_meshopt_compression", "KHR_meshopt_compression"})
    if (extension(json, packed)) refuse_compression(gltf, packed);
  const std::size_t buffer = index_of(gltf, json, "buffer").value_or(0);
  const std::size_t offset = index_of(gltf, json, "byteOffset").value_or(0);
  const std::size_t length = index_of(gltf, json, "byteLength").value_or(0);
  if (buffer >= gltf.buffers.size())
    gltf.fail(
        fmt::format("buffer view {} refers to buffer {}, which does not exist", index, buffer));
  const std::string_view bytes = gltf.buffers[buffer].bytes();
  if (offset > bytes.size() || length > bytes.size() - offset)
    gltf.fail(fmt::format("buffer view {} ends beyond its buffer of {} bytes", index, bytes.size()),
              "is the file damaged or cut off?");
  return {bytes.substr(offset, length), index_of(gltf, json, "byteStride").value_or(0), buffer,
          offset};
}

std::optional<std::string> uri_bytes(const GltfDocument& gltf, std::string_view uri) {
  if (is_data_uri(uri)) {
    auto bytes = decode_data_uri(uri);
    if (!bytes) gltf.fail("an embedded 'data:' is not valid base64");
    return bytes;
  }
  const auto path = find_beside(gltf.source.path, decode_uri(uri));
  if (!path) return std::nullopt;
  return load(*path).bytes;
}

}  // namespace penumbra
