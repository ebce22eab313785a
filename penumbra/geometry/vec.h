// SPDX-License-Identifier: MIT
// Three-vectors: `Vec3f` in rays and scenes, `Vec3d` wherever a bound or a set is computed.
#pragma once

#include <algorithm>
#include <cmath>

namespace penumbra {

/// A point, direction or linear RGB colour. Number is float or double.
template <typename Number>
struct Vec3 {
  Number x = 0, y = 0, z = 0;

  constexpr Vec3() = default;
  constexpr Vec3(Number x_, Number y_, Number z_) : x(x_), y(y_), z(z_) {}
  /// Conversion rounds to nearest; use `round_up`/`round_down` where a bound must hold.
  template <typename Other>
  constexpr explicit Vec3(const Vec3<Other>& v)
      : x(static_cast<Number>(v.x)), y(static_cast<Number>(v.y)), z(static_cast<Number>(v.z)) {}

  constexpr Number operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  constexpr Number& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  constexpr bool operator==(const Vec3&) const = default;
};

/// In scenes and rays, and while sets are built.
using Vec3f = Vec3<float>;
using Vec3d = Vec3<double>;

/// Texture coordinates: u to the right, v up, (0, 0) at the image's lower left corner.
struct Vec2f {
  float u = 0, v = 0;
};

// clang-format off
template <typename N> constexpr Vec3<N> operator+(Vec3<N> a, Vec3<N> b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
template <typename N> constexpr Vec3<N> operator-(Vec3<N> a, Vec3<N> b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
template <typename N> constexpr Vec3<N> operator*(Vec3<N> a, Vec3<N> b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
template <typename N> constexpr Vec3<N> operator-(Vec3<N> a) { return {-a.x, -a.y, -a.z}; }
template <typename N> constexpr Vec3<N> operator*(Vec3<N> a, N s) { return {a.x * s, a.y * s, a.z * s}; }
template <typename N> constexpr Vec3<N> operator*(N s, Vec3<N> a) { return a * s; }
template <typename N> constexpr Vec3<N> operator/(Vec3<N> a, N s) { return {a.x / s, a.y / s, a.z / s}; }
template <typename N> constexpr Vec3<N>& operator+=(Vec3<N>& a, Vec3<N> b) { return a = a + b; }
template <typename N> constexpr Vec3<N>& operator*=(Vec3<N>& a, N s) { return a = a * s; }
template <typename N> constexpr N dot(Vec3<N> a, Vec3<N> b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
template <typename N> constexpr Vec3<N> cross(Vec3<N> a, Vec3<N> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <typename N> constexpr Vec3<N> min(Vec3<N> a, Vec3<N> b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
template <typename N> constexpr Vec3<N> max(Vec3<N> a, Vec3<N> b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}
template <typename N> constexpr N length_squared(Vec3<N> a) { return dot(a, a); }
template <typename N> N length(Vec3<N> a) { return std::sqrt(dot(a, a)); }
/// Largest absolute coordinate.
template <typename N> N max_abs(Vec3<N> a) { return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)}); }
template <typename N> bool is_finite(Vec3<N> a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }
// clang-format on

/// Unit vector along `a`. Scaled first, so that neither tiny nor huge vectors under- or overflow;
/// the zero vector (and one that is not finite) gives zero.
template <typename N>
Vec3<N> normalize(Vec3<N> a) {
  const N scale = max_abs(a);
  if (!(scale > 0) || !std::isfinite(scale)) return {};
  a = a / scale;
  return a / length(a);
}

/// Unit length; zero where there is no direction. What has it to float precision stays as it is, so
/// that doing so again changes no bit.
inline Vec3f unit(Vec3f v) {
  if (std::abs(length_squared(Vec3d(v)) - 1) < 1e-6) return v;
  return is_finite(v) ? normalize(v) : Vec3f{};
}

/// Two unit vectors that make a right-handed frame (u, v, n) with the unit vector n
/// (Duff et al., Building an Orthonormal Basis, Revisited, JCGT 2017).
template <typename N>
struct Frame {
  Vec3<N> u, v, n;
};

template <typename N>
Frame<N> frame_around(Vec3<N> n) {
  const N sign = std::copysign(N(1), n.z);
  const N a = N(-1) / (sign + n.z);
  const N b = n.x * n.y * a;
  return {{N(1) + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

}  // namespace penumbra
