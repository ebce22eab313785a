// SPDX-License-Identifier: MIT
// The loops over the samples of one receiver, compiled for each instruction set and chosen at run
// time. All are plain float code without fused operations: every instruction set gives the same
// bits.
#pragma once

#include <cstddef>
#include <cstdint>

#include "penumbra/geometry/vec.h"

namespace penumbra {

/// One array a coordinate. Loops over lights read (u, v) in [0, 1)² from x and y and replace them.
struct SampleArrays {
  float *x, *y, *z;
  std::size_t count;
};

/// The 32 bits in reverse order.
[[gnu::always_inline]] constexpr std::uint32_t reversed_bits(std::uint32_t x) {
  x = (x >> 16) | (x << 16);
  x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
  x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
  x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
  return ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
}

/// Owen scramble of bit-reversed coordinates: uniform floats in [0, 1).
struct OwenScramble {
  std::uint32_t offset;
  std::uint32_t factor;  ///< odd
};
void scramble_to_units(const std::uint32_t* reversed, std::size_t count, OwenScramble scramble,
                       float* units);

/// Directions within an angle of an axis, uniform in solid angle, unit length.
struct ConeSampling {
  Frame<float> frame;  ///< n is the axis
  float one_minus_cos = 0;
  float root = 0;  ///< of one_minus_cos, taken in double: that may be too small for float
};
void sample_cone(const ConeSampling& cone, SampleArrays samples);

/// Nearest points of a ball along the directions of the cone that it fills. With m² in [0, 1] the
/// share of the cone's solid angle up to a direction, h = m² (1 - cos_max) is 1 - cos of that
/// direction, q² = (1 - m²) (1 - cos_max) (1 + cos_max - h) is sin²_max - sin², and the distance
///   t = D (cos - q) = D cos²_max / (cos + q),
/// all without cancellation. The sample is base + axial n + t sin (cosφ u + sinφ v) with
///   axial = (of_cos cos + of_q q) / (cos + q),
/// measured from p (base 0, axial = t cos) or from the ball's centre (axial = t cos - D).
struct BallSampling {
  ConeSampling cone;
  Vec3f base;
  float of_cos = 0, of_q = 0;
  float nearest = 0;  ///< D cos²_max
};
void sample_ball(const BallSampling& ball, SampleArrays samples);

/// Exit points of directions uniform over the sphere, from inside a ball.
struct InsideBallSampling {
  Frame<float> frame;  ///< n points to the centre
  float radius = 1;
  float distance = 0;  ///< of p from the centre, in radii
  float power = 1;     ///< 1 - distance², not below 0
};
void sample_ball_from_inside(const InsideBallSampling& ball, SampleArrays samples);

/// center + (2u - 1) u + (2v - 1) v: uniform by area.
struct AreaSampling {
  Vec3f center, u, v;
};
void sample_area(const AreaSampling& area, SampleArrays samples);

/// Urena, Fajardo, King 2013, Algorithm 1-2, in their notation but for z0, which is positive here,
/// and xu, which needs one root less: 1 / cu² - 1 = fu² - (1 - b0²). x and y are along u and v.
struct RectangleSampling {
  AreaSampling area;
  double x0 = 0, x1 = 0, y0 = 0, y1 = 0, z0 = 0;
  double b0 = 0, b1 = 0, one_minus_b0_squared = 0;
  double k = 0, solid_angle = 0;
};
void sample_rectangle(const RectangleSampling& rectangle, SampleArrays samples);

/// Cosine between each direction and a unit normal; -1 where that is not above 0, and for NaN.
void weigh_directions(Vec3f normal, const float* x, const float* y, const float* z,
                      std::size_t count, float* weight);

}  // namespace penumbra
