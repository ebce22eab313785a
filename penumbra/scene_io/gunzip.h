// SPDX-License-Identifier: MIT
// gzip unpacked piece by piece.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string_view>

namespace penumbra {

/// Whether bytes begin as gzip does (RFC 1952: magic number, and deflate).
bool is_gzip(std::string_view bytes);

/// Unpacks all members of a gzip stream, one after the other; zeros that pad it at the end are
/// allowed. Throws Error with the byte where the stream is broken, cut off, or something follows
/// it.
class Gunzip {
 public:
  /// `path` is what messages name.
  explicit Gunzip(std::filesystem::path path);
  ~Gunzip();
  Gunzip(Gunzip&&) noexcept;
  Gunzip& operator=(Gunzip&&) noexcept;

  struct Step {
    std::size_t taken = 0;  ///< packed bytes that are done with
    std::size_t given = 0;  ///< bytes that were unpacked
  };
  /// Unpacks some of `packed` to `room`. `is_last`: no more bytes come after these. Takes nothing
  /// and gives nothing where it needs more bytes than these.
  Step unpack(std::string_view packed, bool is_last, char* room, std::size_t room_size);

  /// Between two members: the stream may end here.
  bool may_end() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace penumbra
