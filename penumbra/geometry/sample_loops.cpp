// SPDX-License-Identifier: MIT
#include "penumbra/geometry/sample_loops.h"

#include <algorithm>
#include <cmath>

// Highway includes this file again for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "penumbra/geometry/sample_loops.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace penumbra::HWY_NAMESPACE {
namespace {

/// Laine & Karras 2011 (a hash in which each bit depends on lower ones only is an Owen scramble of
/// the reversed number); constants by N. Vegdahl (2021), who searched for better ones.
void ScrambleToUnits(const std::uint32_t* __restrict reversed, std::size_t count,
                     OwenScramble scramble, float* __restrict units) {
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t x = reversed[i];
    x ^= x * 0x3d20adeau;
    x = (x + scramble.offset) * scramble.factor;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    // Signed numbers convert in one instruction, and 24 bits have no sign.
    units[i] = static_cast<float>(static_cast<std::int32_t>(reversed_bits(x) >> 8)) * 0x1p-24f;
  }
}

struct DiskPoint {
  float x, y;
  float radius_squared;
};

/// Square to unit disk, areas in proportion (P. Shirley, K. Chiu, A Low Distortion Map Between Disk
/// and Square, Journal of Graphics Tools 1997). Sine and cosine of [-pi/4, pi/4] are polynomials
/// through Chebyshev nodes, off by less than 10⁻⁹.
HWY_INLINE DiskPoint to_disk(float u, float v) {
  const float a = 2 * u - 1, b = 2 * v - 1;
  const bool is_wide = std::abs(a) > std::abs(b);
  const float major = is_wide ? a : b, minor = is_wide ? b : a;
  const float t = minor / (major == 0 ? 1.0f : major), t2 = t * t;
  const float sine =
      t * (0.78539816f + t2 * (-0.080745512f + t2 * (0.0024903932f + t2 * -3.6572393e-5f)));
  const float cosine =
      1 + t2 * (-0.30842514f + t2 * (0.015854325f + t2 * (-3.2593859e-4f + t2 * 3.5297971e-6f)));
  const float along = major * cosine, across = major * sine;
  return {is_wide ? along : across, is_wide ? across : along, major * major};
}

void SampleCone(const ConeSampling& cone, SampleArrays samples) {
  const Frame<float> f = cone.frame;
  const float k = cone.one_minus_cos, root = cone.root;
  float* __restrict xs = samples.x;
  float* __restrict ys = samples.y;
  float* __restrict zs = samples.z;
  for (std::size_t i = 0; i < samples.count; ++i) {
    const DiskPoint disk = to_disk(xs[i], ys[i]);
    const float h = k * disk.radius_squared;
    const float cosine = 1 - h, across = root * std::sqrt(2 - h);
    const float x = across * disk.x, y = across * disk.y;
    xs[i] = f.n.x * cosine + (f.u.x * x + f.v.x * y);
    ys[i] = f.n.y * cosine + (f.u.y * x + f.v.y * y);
    zs[i] = f.n.z * cosine + (f.u.z * x + f.v.z * y);
  }
}

void SampleBall(const BallSampling& ball, SampleArrays samples) {
  const Frame<float> f = ball.cone.frame;
  const Vec3f base = ball.base;
  const float k = ball.cone.one_minus_cos, root = ball.cone.root;
  const float of_cos = ball.of_cos, of_q = ball.of_q, nearest = ball.nearest;
  float* __restrict xs = samples.x;
  float* __restrict ys = samples.y;
  float* __restrict zs = samples.z;
  for (std::size_t i = 0; i < samples.count; ++i) {
    const DiskPoint disk = to_disk(xs[i], ys[i]);
    const float h = k * disk.radius_squared;
    const float cosine = 1 - h;
    const float q = root * std::sqrt((1 - disk.radius_squared) * ((2 - k) - h));
    const float inverse = 1 / (cosine + q);
    const float axial = (of_cos * cosine + of_q * q) * inverse;
    const float across = nearest * inverse * (root * std::sqrt(2 - h));
    const float x = across * disk.x, y = across * disk.y;
    xs[i] = base.x + (f.n.x * axial + (f.u.x * x + f.v.x * y));
    ys[i] = base.y + (f.n.y * axial + (f.u.y * x + f.v.y * y));
    zs[i] = base.z + (f.n.z * axial + (f.u.z * x + f.v.z * y));
  }
}

void SampleBallFromInside(const InsideBallSampling& ball, SampleArrays samples) {
  const Frame<float> f = ball.frame;
  const float radius = ball.radius, distance = ball.distance, power = ball.power;
  float* __restrict xs = samples.x;
  float* __restrict ys = samples.y;
  float* __restrict zs = samples.z;
  for (std::size_t i = 0; i < samples.count; ++i) {
    const DiskPoint disk = to_disk(xs[i], ys[i]);
    const float cosine = 1 - 2 * disk.radius_squared;
    const float across = 2 * std::sqrt(1 - disk.radius_squared);
    // The larger root of t² - 2 t D cos - power = 0, in radii.
    const float half = distance * cosine, root = std::sqrt(half * half + power);
    const float other = power / (cosine < 0 ? root - half : 1.0f);
    const float t = radius * (cosine < 0 ? other : half + root);
    const float axial = t * cosine, x = t * across * disk.x, y = t * across * disk.y;
    xs[i] = f.n.x * axial + (f.u.x * x + f.v.x * y);
    ys[i] = f.n.y * axial + (f.u.y * x + f.v.y * y);
    zs[i] = f.n.z * axial + (f.u.z * x + f.v.z * y);
  }
}

void SampleArea(const AreaSampling& area, SampleArrays samples) {
  const Vec3f c = area.center, u = area.u, v = area.v;
  float* __restrict xs = samples.x;
  float* __restrict ys = samples.y;
  float* __restrict zs = samples.z;
  for (std::size_t i = 0; i < samples.count; ++i) {
    const float a = 2 * xs[i] - 1, b = 2 * ys[i] - 1;
    xs[i] = c.x + (a * u.x + b * v.x);
    ys[i] = c.y + (a * u.y + b * v.y);
    zs[i] = c.z + (a * u.z + b * v.z);
  }
}

struct SineCosine {
  double sine, cosine;
};

/// For angles of a few turns at most. Polynomials through Chebyshev nodes on [-pi/4, pi/4], off by
/// less than 10⁻¹⁵.
HWY_INLINE SineCosine sine_cosine(double angle) {
  constexpr double to_integer = 0x1.8p52;  // adding and subtracting it rounds
  const double quarters = (angle * 0.63661977236758134 + to_integer) - to_integer;
  const double r = (angle - quarters * 1.5707963267948966) - quarters * 6.123233995736766e-17;
  const double r2 = r * r;
  const double s =
      r *
      (1 + r2 * (-0.16666666666666438 +
                 r2 * (0.00833333333325595 + r2 * (-0.0001984126976027713 +
                                                   r2 * (2.7557280605137025e-06 +
                                                         r2 * (-2.504284195671661e-08 +
                                                               r2 * (1.4969852378065674e-10)))))));
  const double c =
      1 +
      r2 * (-0.500000000000005 +
            r2 * (0.04166666666680603 +
                  r2 * (-0.0013888888902550787 +
                        r2 * (2.4801593584718262e-05 +
                              r2 * (-2.75587967914727e-07 +
                                    r2 * (2.104883123252838e-09 + r2 * -1.930912389896824e-11))))));
  const double turns = ((quarters * 0.25 - 0.375) + to_integer) - to_integer;  // rounded down
  const double quadrant = quarters - 4 * turns;
  const bool is_odd = quadrant == 1 || quadrant == 3;
  const double sine = is_odd ? c : s, cosine = is_odd ? s : c;
  return {quadrant >= 2 ? -sine : sine, quadrant == 1 || quadrant == 2 ? -cosine : cosine};
}

void SampleRectangle(const RectangleSampling& rectangle, SampleArrays samples) {
  const RectangleSampling r = rectangle;
  const double x_middle = 0.5 * (r.x0 + r.x1), to_a = 2 / (r.x1 - r.x0);
  const double y_middle = 0.5 * (r.y0 + r.y1), to_b = 2 / (r.y1 - r.y0);
  float* __restrict xs = samples.x;
  float* __restrict ys = samples.y;
  float* __restrict zs = samples.z;
  for (std::size_t i = 0; i < samples.count; ++i) {
    const SineCosine au = sine_cosine(xs[i] * r.solid_angle + r.k);
    const double fu = (au.cosine * r.b0 - r.b1) / au.sine;
    const double x_size = r.z0 / std::sqrt(std::max(fu * fu - r.one_minus_b0_squared, 1e-300));
    const double xu = std::max(r.x0, std::min(r.x1, fu < 0 ? -x_size : x_size));
    const double d2 = xu * xu + r.z0 * r.z0;
    const double h0 = r.y0 / std::sqrt(d2 + r.y0 * r.y0), h1 = r.y1 / std::sqrt(d2 + r.y1 * r.y1);
    const double hv = h0 + ys[i] * (h1 - h0);
    const double yv_free = hv * std::sqrt(d2 / std::max(1 - hv * hv, 1e-300));
    const double yv = std::max(r.y0, std::min(r.y1, yv_free));
    const float a = static_cast<float>((xu - x_middle) * to_a);
    const float b = static_cast<float>((yv - y_middle) * to_b);
    xs[i] = r.area.center.x + (a * r.area.u.x + b * r.area.v.x);
    ys[i] = r.area.center.y + (a * r.area.u.y + b * r.area.v.y);
    zs[i] = r.area.center.z + (a * r.area.u.z + b * r.area.v.z);
  }
}

void WeighDirections(Vec3f normal, const float* __restrict xs, const float* __restrict ys,
                     const float* __restrict zs, std::size_t count, float* __restrict weight) {
  for (std::size_t i = 0; i < count; ++i) {
    const float x = xs[i], y = ys[i], z = zs[i];
    const float along = normal.x * x + normal.y * y + normal.z * z;
    const float cosine = along / std::sqrt(x * x + y * y + z * z);
    weight[i] = along > 0 ? cosine : -1;
  }
}

}  // namespace
}  // namespace penumbra::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace penumbra {

HWY_EXPORT(ScrambleToUnits);
HWY_EXPORT(SampleCone);
HWY_EXPORT(SampleBall);
HWY_EXPORT(SampleBallFromInside);
HWY_EXPORT(SampleArea);
HWY_EXPORT(SampleRectangle);
HWY_EXPORT(WeighDirections);

void scramble_to_units(const std::uint32_t* reversed, std::size_t count, OwenScramble scramble,
                       float* units) {
  HWY_DYNAMIC_DISPATCH(ScrambleToUnits)(reversed, count, scramble, units);
}

void sample_cone(const ConeSampling& cone, SampleArrays samples) {
  HWY_DYNAMIC_DISPATCH(SampleCone)(cone, samples);
}

void sample_ball(const BallSampling& ball, SampleArrays samples) {
  HWY_DYNAMIC_DISPATCH(SampleBall)(ball, samples);
}

void sample_ball_from_inside(const InsideBallSampling& ball, SampleArrays samples) {
  HWY_DYNAMIC_DISPATCH(SampleBallFromInside)(ball, samples);
}

void sample_area(const AreaSampling& area, SampleArrays samples) {
  HWY_DYNAMIC_DISPATCH(SampleArea)(area, samples);
}

void sample_rectangle(const RectangleSampling& rectangle, SampleArrays samples) {
  HWY_DYNAMIC_DISPATCH(SampleRectangle)(rectangle, samples);
}

void weigh_directions(Vec3f normal, const float* x, const float* y, const float* z,
                      std::size_t count, float* weight) {
  HWY_DYNAMIC_DISPATCH(WeighDirections)(normal, x, y, z, count, weight);
}

}  // namespace penumbra
#endif
