// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/gunzip.h"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "penumbra/scene/error.h"

namespace penumbra {
namespace {

constexpr std::string_view magic = "\x1f\x8b\x08";

uInt part(std::size_t size) {
  return static_cast<uInt>(std::min<std::size_t>(size, std::numeric_limits<uInt>::max()));
}

}  // namespace

struct Gunzip::State {
  std::filesystem::path path;
  z_stream stream{};
  std::size_t at = 0;  ///< packed bytes so far
  bool is_between = true;

  explicit State(std::filesystem::path p) : path(std::move(p)) {
    if (inflateInit2(&stream, 15 + 16) != Z_OK) fail("zlib does not start");
  }
  ~State() { inflateEnd(&stream); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  [[noreturn]] void fail(const char* what) const {
    throw Error({path.string(), {}, at}, std::string("broken gzip data: ") + what,
                "unpack it with gunzip to see what is left");
  }

  /// What stands between members: the next one, or padding.
  Step begin_member(std::string_view packed, bool is_last) {
    if (packed.empty() || (packed.size() < magic.size() && !is_last)) return {};
    if (is_gzip(packed)) {
      is_between = false;
      inflateReset(&stream);
      return {};
    }
    if (packed.find_first_not_of('\0') != std::string_view::npos) fail("something else follows it");
    at += packed.size();
    return {packed.size(), 0};
  }

  Step inflate_some(std::string_view packed, bool is_last, char* room, std::size_t room_size) {
    // zlib's interface is older than const.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream.avail_in = part(packed.size());
    stream.next_out = reinterpret_cast<Bytef*>(room);
    stream.avail_out = part(room_size);
    const Step most{stream.avail_in, stream.avail_out};
    const int status = inflate(&stream, Z_NO_FLUSH);
    const Step step{most.taken - stream.avail_in, most.given - stream.avail_out};
    at += step.taken;
    if (status == Z_STREAM_END) is_between = true;
    if (status == Z_STREAM_END || status == Z_OK) return step;
    if (status == Z_MEM_ERROR) fail("out of memory");
    if (status != Z_BUF_ERROR) fail(stream.msg != nullptr ? stream.msg : "not readable");
    if (is_last && step.taken == packed.size() && room_size > 0) fail("it is cut off");
    return step;
  }
};

bool is_gzip(std::string_view bytes) { return bytes.starts_with(magic); }

Gunzip::Gunzip(std::filesystem::path path) : state_(std::make_unique<State>(std::move(path))) {}
Gunzip::~Gunzip() = default;
Gunzip::Gunzip(Gunzip&&) noexcept = default;
Gunzip& Gunzip::operator=(Gunzip&&) noexcept = default;

Gunzip::Step Gunzip::unpack(std::string_view packed, bool is_last, char* room,
                            std::size_t room_size) {
  if (state_->is_between) {
    const Step step = state_->begin_member(packed, is_last);
    if (state_->is_between) return step;
  }
  return state_->inflate_some(packed, is_last, room, room_size);
}

bool Gunzip::may_end() const { return state_->is_between; }

}  // namespace penumbra
