// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/byte_input.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "penumbra/scene/error.h"
#include "penumbra/scene_io/source.h"

namespace penumbra {
namespace {

constexpr std::size_t chunk = std::size_t{1} << 18;

[[noreturn]] void fail_reading(const std::string& name) {
  throw Error({name, {}, {}}, std::string("cannot be read: ") + std::strerror(errno),
              "check its permissions");
}

}  // namespace

ByteInput::ByteInput(const std::filesystem::path& path, Packing packing) : name_(path.string()) {
  if (path == "-") {
    name_ = "standard input";
    file_.number = STDIN_FILENO;
  } else {
    check_readable(path);
    file_.number = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file_.number < 0) fail_reading(name_);
  }
  struct stat facts {};
  if (fstat(file_.number, &facts) == 0 && S_ISREG(facts.st_mode) && facts.st_size > 0)
    size_ = static_cast<std::uint64_t>(facts.st_size);
  constexpr std::size_t magic_size = 3;
  if (packing == Packing::none || !is_gzip(peek(magic_size))) return;
  packed_.assign(buffer_, 0, end_);
  end_ = 0;
  is_packed_end_ = std::exchange(has_ended_, false);
  gunzip_.emplace(name_);
}

ByteInput::ByteInput(std::string name, std::string bytes)
    : name_(std::move(name)),
      size_(bytes.size()),
      read_(bytes.size()),
      buffer_(std::move(bytes)),
      end_(buffer_.size()),
      has_ended_(true) {}

ByteInput::Descriptor::~Descriptor() {
  if (number > STDIN_FILENO) close(number);
}

std::optional<std::uint64_t> ByteInput::remaining() const {
  if (!size_ || gunzip_) return {};
  return *size_ - std::min(*size_, read_) + (end_ - begin_);
}

std::optional<double> ByteInput::share() const {
  if (!size_ || *size_ == 0) return {};
  // What lies in the buffer has still to be answered, but of packed bytes, who knows how many.
  const std::uint64_t waiting = gunzip_ ? 0 : end_ - begin_;
  return std::min(1.0, static_cast<double>(read_ - waiting) / static_cast<double>(*size_));
}

void ByteInput::fill() {
  before_ += begin_;
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  if (buffer_.size() - end_ < chunk) buffer_.resize(std::max(2 * buffer_.size(), 2 * chunk));
  char* const room = buffer_.data() + end_;
  const std::size_t size = std::min(buffer_.size() - end_, chunk);
  end_ += gunzip_ ? unpack_some(room, size) : read_some(room, size);
}

std::size_t ByteInput::read_some(char* room, std::size_t size) {
  for (;;) {
    const ssize_t got = read(file_.number, room, size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail_reading(name_);
    read_ += static_cast<std::uint64_t>(got);
    if (got == 0) has_ended_ = true;
    return static_cast<std::size_t>(got);
  }
}

std::size_t ByteInput::unpack_some(char* room, std::size_t size) {
  for (;;) {
    const std::string_view packed = std::string_view(packed_).substr(packed_begin_);
    const Gunzip::Step step = gunzip_->unpack(packed, is_packed_end_, room, size);
    packed_begin_ += step.taken;
    if (step.given > 0) return step.given;
    if (step.taken > 0) continue;
    if (is_packed_end_) {
      has_ended_ = true;
      return 0;
    }
    packed_.erase(0, packed_begin_);
    packed_begin_ = 0;
    const std::size_t used = packed_.size();
    packed_.resize(used + chunk);
    packed_.resize(used + read_some(packed_.data() + used, chunk));
    is_packed_end_ = std::exchange(has_ended_, false);
  }
}

}  // namespace penumbra
