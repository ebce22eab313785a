// SPDX-License-Identifier: MIT
// Plain values to bytes and back, within one machine; reading trusts nothing.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace penumbra {

template <typename T>
concept PlainValue = std::is_trivially_copyable_v<T>;

class ByteWriter {
 public:
  template <PlainValue T>
  void value(const T& v) {
    bytes_.append(reinterpret_cast<const char*>(&v), sizeof v);
  }
  template <PlainValue T>
  void list(const std::vector<T>& values) {
    value(static_cast<std::uint64_t>(values.size()));
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  }
  void text(std::string_view text) {
    value(static_cast<std::uint64_t>(text.size()));
    bytes_.append(text);
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Once something does not fit, everything it gives is zero or empty, and `is_good` false.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  template <PlainValue T>
  T value() {
    T v{};
    if (const auto piece = take(sizeof v); !piece.empty())
      std::memcpy(static_cast<void*>(&v), piece.data(), sizeof v);
    return v;
  }
  template <PlainValue T>
  std::vector<T> list() {
    std::vector<T> values(count(sizeof(T)));
    const std::string_view piece = take(values.size() * sizeof(T));
    if (!piece.empty()) std::memcpy(static_cast<void*>(values.data()), piece.data(), piece.size());
    return values;
  }
  std::string text() { return std::string(take(count(1))); }
  /// A number of things of at least this many bytes each that are to follow.
  std::size_t count(std::size_t bytes_each) {
    const auto claimed = value<std::uint64_t>();
    if (claimed <= bytes_.size() / bytes_each) return static_cast<std::size_t>(claimed);
    is_good_ = false;
    return 0;
  }
  bool is_good() const { return is_good_; }

 private:
  std::string_view take(std::size_t size) {
    if (!is_good_ || size > bytes_.size()) {
      is_good_ = false;
      return {};
    }
    const std::string_view piece = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return piece;
  }

  std::string_view bytes_;
  bool is_good_ = true;
};

}  // namespace penumbra
