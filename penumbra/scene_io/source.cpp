// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/source.h"

#include "penumbra/scene_io/gunzip.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

namespace penumbra {
namespace {

constexpr std::size_t file_limit = std::size_t{8} << 30;
constexpr std::size_t unpacked_limit = std::size_t{2} << 30;
constexpr std::size_t chunk = std::size_t{1} << 20;

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

std::string read_all(const std::filesystem::path& path) {
  check_readable(path);
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
  if (!file)
    throw Error({path.string(), {}, {}}, std::string("cannot be read: ") + std::strerror(errno),
                "check its permissions");
  std::string bytes;
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!error) bytes.reserve(std::min<std::uintmax_t>(size, file_limit) + 1);
  for (std::size_t used = 0;;) {
    if (used == bytes.capacity()) bytes.reserve(used + std::max(used / 2, chunk));
    bytes.resize(std::min(bytes.capacity(), used + 64 * chunk));
    const std::size_t got = std::fread(bytes.data() + used, 1, bytes.size() - used, file.get());
    used += got;
    if (used > file_limit) throw Error({path.string(), {}, {}}, "is larger than 8 GiB");
    if (got != 0) continue;
    if (std::ferror(file.get()) != 0)
      throw Error({path.string(), {}, {}}, std::string("cannot be read: ") + std::strerror(errno));
    bytes.resize(used);
    return bytes;
  }
}

std::string unpack(const std::filesystem::path& path, std::string_view packed) {
  Gunzip gunzip(path);
  std::string out;
  std::size_t at = 0, used = 0;
  while (at < packed.size() || !gunzip.may_end()) {
    if (used == out.size())
      out.resize(std::min(used + std::max(used, 4 * chunk), unpacked_limit + chunk));
    const Gunzip::Step step =
        gunzip.unpack(packed.substr(at, chunk), packed.size() - at <= chunk, out.data() + used,
                      std::min(out.size() - used, 64 * chunk));
    at += step.taken;
    used += step.given;
    if (used > unpacked_limit)
      throw Error({path.string(), {}, at},
                  "it unpacks to more than 2 GiB, the most that is read from gzip",
                  "unpack it with gunzip, and give the file itself");
  }
  out.resize(used);
  return out;
}

std::string lower_extension(std::filesystem::path path) {
  const auto lower = [](std::string text) {
    for (char& c : text)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
  };
  std::string extension = lower(path.extension().string());
  if (extension == ".gz") extension = lower(path.stem().extension().string());
  return extension.empty() ? extension : extension.substr(1);
}

}  // namespace

void check_readable(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found)
    throw Error({path.string(), {}, {}}, "there is no such file", "check the path");
  if (error) throw Error({path.string(), {}, {}}, "cannot be read: " + error.message());
  if (status.type() == std::filesystem::file_type::directory)
    throw Error({path.string(), {}, {}}, "is a folder", "name a file in it");
  if (status.type() != std::filesystem::file_type::regular &&
      status.type() != std::filesystem::file_type::fifo)
    throw Error({path.string(), {}, {}}, "is neither a file nor a pipe");
}

Source load(const std::filesystem::path& path) {
  Source source{path, lower_extension(path), read_all(path)};
  if (is_gzip(source.bytes)) source.bytes = unpack(path, source.bytes);
  return source;
}

bool Warnings::knows(std::string_view kind) const {
  return std::any_of(entries_.begin(), entries_.end(),
                     [&](const Entry& entry) { return entry.kind == kind; });
}

void Warnings::add(std::string_view kind, std::size_t line) {
  add(kind, {file_, line ? std::optional(line) : std::nullopt, {}});
}

void Warnings::add(std::string_view kind, const Error::Place& place) {
  constexpr std::size_t most_kinds = 50, most_bytes = 300;
  kind = kind.substr(0, most_bytes);
  if (entries_.size() >= most_kinds && !knows(kind)) kind = "something else is odd";
  for (Entry& entry : entries_)
    if (entry.kind == kind) {
      ++entry.count;
      return;
    }
  entries_.push_back({std::string(kind), place, 1});
}

std::vector<std::string> Warnings::lines() const {
  std::vector<std::string> lines;
  for (const Entry& entry : entries_) {
    std::string text = message(entry.place, entry.kind, {});
    if (entry.count > 1) text += fmt::format(" (and {} more)", entry.count - 1);
    lines.push_back(std::move(text));
  }
  return lines;
}

}  // namespace penumbra
