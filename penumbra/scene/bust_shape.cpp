// SPDX-License-Identifier: MIT
#include "penumbra/scene/bust_shape.h"

#include <algorithm>
#include <cmath>

namespace penumbra::detail {

namespace {

/// Union whose seam is rounded over a width of about k (polynomial smooth minimum).
double blend(double a, double b, double k) {
  const double h = std::max(k - std::abs(a - b), 0.0) / k;
  return std::min(a, b) - h * h * k * 0.25;
}
/// a without b, the edge rounded.
double carve(double a, double b, double k) { return -blend(-a, b, k); }
/// What both have, the edge rounded.
double common(double a, double b, double k) { return -blend(-a, -b, k); }

double ball(Vec3d p, Vec3d center, double radius) { return length(p - center) - radius; }

/// About the distance to an ellipsoid.
double ellipsoid(Vec3d p, Vec3d center, Vec3d radii) {
  const Vec3d q = p - center;
  const Vec3d a{q.x / radii.x, q.y / radii.y, q.z / radii.z};
  const Vec3d b{a.x / radii.x, a.y / radii.y, a.z / radii.z};
  const double k = length(a), slope = length(b);
  return slope > 1e-9 ? k * (k - 1) / slope : -std::min({radii.x, radii.y, radii.z});
}

/// A ball drawn along a segment while its radius goes from r0 to r1.
double limb(Vec3d p, Vec3d from, Vec3d to, double r0, double r1) {
  const Vec3d axis = to - from;
  const double t = std::clamp(dot(p - from, axis) / dot(axis, axis), 0.0, 1.0);
  return length(p - from - axis * t) - (r0 + (r1 - r0) * t);
}

/// 0 below a, 1 above b, smooth between.
double ramp(double a, double b, double x) {
  const double t = std::clamp((x - a) / (b - a), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

double skull(Vec3d p) {
  double d = ellipsoid(p, {0, 0.14, 1.42}, {0.76, 0.96, 0.86});
  d = blend(d, ellipsoid(p, {0, -0.24, 0.86}, {0.6, 0.58, 0.84}), 0.3);
  d = blend(d, ellipsoid(p, {0.4, 0.0, 0.46}, {0.2, 0.36, 0.26}), 0.3);       // jaw
  d = blend(d, ellipsoid(p, {0, -0.7, 0.13}, {0.2, 0.18, 0.16}), 0.2);        // chin
  d = blend(d, ellipsoid(p, {0.42, -0.55, 0.93}, {0.2, 0.2, 0.15}), 0.22);    // cheekbone
  d = blend(d, ellipsoid(p, {0.28, -0.74, 1.36}, {0.32, 0.13, 0.08}), 0.14);  // brow
  return blend(d, ellipsoid(p, {0, -0.68, 0.5}, {0.3, 0.18, 0.22}), 0.2);     // around the mouth
}

double eyes(double d, Vec3d p) {
  d = carve(d, ellipsoid(p, {0.3, -0.92, 1.15}, {0.19, 0.13, 0.12}), 0.12);
  d = blend(d, ball(p, {0.3, -0.665, 1.15}, 0.145), 0.02);
  // Lids: a slightly larger ball, cut to what lies above and below the slit.
  const double slit = std::abs(p.z - 1.15 + 0.18 * (p.x - 0.3) * (p.x - 0.3)) - 0.055;
  const double lids = common(ball(p, {0.3, -0.66, 1.15}, 0.172), -slit, 0.02);
  return blend(d, lids, 0.03);
}

double nose(double d, Vec3d p) {
  d = blend(d, limb(p, {0, -0.78, 1.3}, {0, -1.04, 0.83}, 0.07, 0.095), 0.12);
  d = blend(d, ball(p, {0, -1.05, 0.82}, 0.1), 0.05);
  d = blend(d, ellipsoid(p, {0.115, -0.93, 0.78}, {0.075, 0.11, 0.075}), 0.06);
  return carve(d, ellipsoid(p, {0.065, -0.99, 0.71}, {0.035, 0.06, 0.045}), 0.03);
}

double mouth(double d, Vec3d p) {
  d = blend(d, ellipsoid(p, {0.08, -0.87, 0.545}, {0.16, 0.07, 0.045}), 0.06);
  d = blend(d, ellipsoid(p, {0, -0.86, 0.44}, {0.17, 0.075, 0.055}), 0.06);
  return carve(d, ellipsoid(p, {0, -0.96, 0.495}, {0.24, 0.09, 0.016}), 0.04);
}

double ear(Vec3d p) {
  double d = ellipsoid(p, {0.76, 0.2, 1.1}, {0.1, 0.18, 0.3});
  d = carve(d, ellipsoid(p, {0.86, 0.15, 1.13}, {0.09, 0.1, 0.17}), 0.05);
  return blend(d, ball(p, {0.76, 0.03, 1.07}, 0.05), 0.06);
}

/// Locks of hair that run down from the crown in waves.
double hair(double d, Vec3d p) {
  const Vec3d q = p - Vec3d{0, 0.3, 1.35};
  const double around = std::atan2(q.x, -q.y), down = std::atan2(std::hypot(q.x, q.y), q.z);
  const double hairline = 0.72 + 0.95 * ramp(0.5, 1.5, around) + 0.55 * ramp(1.6, 2.6, around);
  const double mask = ramp(0.1, -0.1, down - hairline);
  const double wave = around * 9 + 1.1 * std::sin(down * 9 + 2 * std::sin(around * 3));
  const double locks = 0.5 + 0.5 * std::sin(wave * 2);
  const double strands = 0.5 + 0.5 * std::sin(wave * 8 + 1.5 * std::sin(down * 14));
  return d - mask * (0.07 + 0.055 * locks + 0.012 * strands);
}

double neck(Vec3d p) {
  double d = limb(p, {0, 0.2, 0.55}, {0, 0.32, -0.9}, 0.52, 0.6);
  d = blend(d, limb(p, {0.5, 0.22, 0.6}, {0.1, -0.26, -0.92}, 0.12, 0.09), 0.2);
  return blend(d, ball(p, {0, -0.3, -0.2}, 0.09), 0.18);
}

double torso(Vec3d p) {
  double d = limb(p, {0.2, 0.4, -0.6}, {1.35, 0.28, -1.15}, 0.34, 0.4);
  d = blend(d, ellipsoid(p, {0, 0.2, -1.7}, {1.35, 0.72, 0.95}), 0.4);
  d = blend(d, ellipsoid(p, {0.55, -0.32, -1.65}, {0.55, 0.3, 0.42}), 0.3);
  d = blend(d, limb(p, {0.12, -0.38, -1.02}, {1.2, 0.0, -0.9}, 0.07, 0.06), 0.16);
  // The cut of the bust: rounded below, straight at the arms.
  return common(d, ellipsoid(p, {0, 0.2, -0.75}, {1.52, 2.2, 1.45}), 0.06);
}

double plinth(Vec3d p) {
  const double r = std::hypot(p.x, p.y - 0.2);
  const auto drum = [&](double low, double high, double radius) {
    return std::max({r - radius, p.z - high, low - p.z});
  };
  double d = drum(-2.8, -2.0, 0.36 + 0.22 * (p.z + 2.45) * (p.z + 2.45)) * 0.9;
  const double ring = std::hypot(r - 0.42, p.z + 2.66) - 0.07;
  d = blend(d, ring, 0.03);
  const double half = std::max(std::abs(p.x), std::abs(p.y - 0.2)) - 0.72;
  const double slab = std::max(half, std::abs(p.z + 2.9) - (2.9 + bust_bottom) * -1);
  return blend(d, slab, 0.03);
}

}  // namespace

double bust_field(Vec3d p) {
  const Vec3d half{std::sqrt(p.x * p.x + 1e-4), p.y, p.z};  // both sides alike, smooth between
  double head = skull(half);
  head = hair(head, half);
  head = eyes(head, half);
  head = nose(head, half);
  head = mouth(head, half);
  head = blend(head, ear(half), 0.05);
  double d = blend(head, neck(half), 0.14);
  d = blend(d, torso(half), 0.3);
  return blend(d, plinth(p), 0.05);
}

}  // namespace penumbra::detail
