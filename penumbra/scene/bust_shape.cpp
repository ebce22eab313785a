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

/// Relief is left out where the surface cannot be.
constexpr double relief_reach = 0.3;

/// 0 below a, 1 above b, smooth between.
double ramp(double a, double b, double x) {
  const double t = std::clamp((x - a) / (b - a), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// |x|, rounded within about `width` of 0.
double soft_abs(double x, double width) { return std::sqrt(x * x + width * width); }

double skull(Vec3d p) {
  double d = ellipsoid(p, {0, 0.14, 1.42}, {0.76, 0.96, 0.86});
  d = blend(d, ellipsoid(p, {0, -0.24, 0.86}, {0.6, 0.58, 0.82}), 0.3);
  d = blend(d, limb(p, {0.46, 0.1, 0.52}, {0.13, -0.6, 0.13}, 0.17, 0.15), 0.25);    // jaw
  d = blend(d, ellipsoid(p, {0, -0.7, 0.13}, {0.2, 0.15, 0.14}), 0.2);               // chin
  d = blend(d, ellipsoid(p, {0.42, -0.52, 0.93}, {0.2, 0.2, 0.15}), 0.22);           // cheekbone
  d = blend(d, limb(p, {0.1, -0.79, 1.335}, {0.5, -0.6, 1.35}, 0.075, 0.05), 0.14);  // brow
  return blend(d, ellipsoid(p, {0, -0.66, 0.5}, {0.28, 0.17, 0.22}), 0.2);  // around the mouth
}

double eyes(double d, Vec3d p) {
  constexpr Vec3d eye{0.3, -0.66, 1.15};
  d = carve(d, ellipsoid(p, {0.3, -0.9, 1.15}, {0.2, 0.14, 0.11}), 0.1);
  d = blend(d, ball(p, eye, 0.145), 0.02);
  // Lids: a slightly larger ball, cut to what lies above and below the slit.
  const double aside = p.x - eye.x;
  const double slit = std::abs(p.z - eye.z + 1.5 * aside * aside) - 0.05 + 1.2 * aside * aside;
  const double lids = common(ball(p, eye, 0.178), -slit, 0.02);
  return blend(d, lids, 0.03);
}

double nose(double d, Vec3d p) {
  d = blend(d, limb(p, {0, -0.78, 1.3}, {0, -1.02, 0.83}, 0.065, 0.09), 0.12);
  d = blend(d, ball(p, {0, -1.03, 0.82}, 0.1), 0.05);
  d = blend(d, ellipsoid(p, {0.11, -0.92, 0.785}, {0.07, 0.11, 0.07}), 0.06);
  return carve(d, ellipsoid(p, {0.06, -0.97, 0.705}, {0.035, 0.055, 0.05}), 0.03);
}

double mouth(double d, Vec3d p) {
  const double upper = ellipsoid(p, {0.05, -0.815, 0.55}, {0.14, 0.08, 0.055});
  const double lower = ellipsoid(p, {0, -0.81, 0.44}, {0.14, 0.085, 0.062});
  return blend(d, blend(upper, lower, 0.015), 0.05);
}

double ear(Vec3d p) {
  double d = ellipsoid(p, {0.75, 0.22, 1.08}, {0.1, 0.18, 0.29});
  d = carve(d, ellipsoid(p, {0.86, 0.17, 1.12}, {0.09, 0.1, 0.17}), 0.05);
  return blend(d, ball(p, {0.73, 0.05, 1.05}, 0.05), 0.06);
}

/// Locks of hair that run down from the crown in waves.
double hair(double d, Vec3d p) {
  if (std::abs(d) > relief_reach) return d;
  const Vec3d q = p - Vec3d{0, 0.3, 1.35};
  const double out = std::hypot(q.x, q.y);
  const double around = std::atan2(q.x, -q.y), down = std::atan2(out, q.z);
  const double hairline = 1.0 + 0.5 * ramp(0.3, 1.2, around) + 0.8 * ramp(1.5, 2.0, around);
  const double mask = ramp(0.07, -0.12, down - hairline);
  const double wave = around * 8 + 1.3 * std::sin(down * 7 + 1.5 * std::sin(around * 4));
  const double locks = soft_abs(std::sin(wave), 0.18);
  const double strands = std::sin(wave * 4 + 0.8 * std::sin(down * 17));
  const double crown = ramp(0.15, 0.7, out);
  return d - mask * (0.05 + crown * (0.075 * locks + 0.01 * crown * strands));
}

double head(Vec3d p) {
  double d = hair(skull(p), p);
  const bool is_face = p.y < -0.3 && p.z > 0.25 && p.z < 1.6;
  if (is_face) d = mouth(nose(eyes(d, p), p), p);
  return blend(d, ear(p), 0.05);
}

double neck(Vec3d p) {
  double d = limb(p, {0, 0.2, 0.55}, {0, 0.32, -0.9}, 0.52, 0.6);
  d = blend(d, limb(p, {0.5, 0.22, 0.6}, {0.1, -0.26, -0.92}, 0.12, 0.09), 0.2);
  return blend(d, ball(p, {0, -0.27, -0.35}, 0.08), 0.2);
}

/// Chest and shoulders, alike on both sides.
double chest(Vec3d p) {
  double d = limb(p, {0.2, 0.4, -0.6}, {1.35, 0.28, -1.15}, 0.34, 0.4);
  d = blend(d, ellipsoid(p, {0, 0.2, -1.7}, {1.35, 0.72, 0.95}), 0.4);
  d = blend(d, ellipsoid(p, {0.55, -0.32, -1.65}, {0.55, 0.3, 0.42}), 0.3);
  return blend(d, limb(p, {0.12, -0.38, -1.02}, {1.2, 0.0, -0.9}, 0.07, 0.06), 0.16);
}

/// A cloth thrown over the left shoulder, in folds that fan out from it.
double cloth(double d, Vec3d p) {
  if (std::abs(d) > relief_reach) return d;
  const double across = 0.8 * (p.x - 0.42) - 0.6 * (p.z + 0.75);
  const double along = -0.6 * (p.x - 0.42) - 0.8 * (p.z + 0.75);
  const double spread = across / (1 + 0.35 * std::clamp(along, -0.8, 2.0));
  const double phase = spread * 11 + 0.5 * std::sin(along * 2.2 + p.y);
  const double folds = soft_abs(std::sin(phase), 0.4);
  const double mask = ramp(-0.03, 0.05, across);
  return d - mask * (0.05 + 0.075 * folds + 0.004 * std::sin(phase * 3 + 2 * std::sin(along * 6)));
}

double torso(Vec3d p, Vec3d half) {
  const double d = cloth(chest(half), p);
  // The cut of the bust: rounded below, straight at the arms.
  return common(d, ellipsoid(half, {0, 0.2, -0.75}, {1.52, 2.2, 1.45}), 0.06);
}

double plinth(Vec3d p) {
  constexpr double slab_middle = -2.9;
  const double r = std::hypot(p.x, p.y - 0.2);
  const auto drum = [&](double low, double high, double radius) {
    return std::max({r - radius, p.z - high, low - p.z});
  };
  double d = drum(-2.8, -2.0, 0.36 + 0.22 * (p.z + 2.45) * (p.z + 2.45)) * 0.9;
  const double ring = std::hypot(r - 0.42, p.z + 2.66) - 0.07;
  d = blend(d, ring, 0.06);
  const double half = std::max(std::abs(p.x), std::abs(p.y - 0.2)) - 0.72;
  const double slab = std::max(half, std::abs(p.z - slab_middle) - (slab_middle - bust_bottom));
  return blend(d, slab, 0.03);
}

}  // namespace

double bust_field(Vec3d p) {
  const Vec3d half{soft_abs(p.x, 0.01), p.y, p.z};  // both sides alike, smooth between
  double d = neck(half);
  // What lies too far above or below to touch the surface is left out.
  if (p.z > -0.4) d = blend(d, head(half), 0.14);
  if (p.z < 0.2) d = blend(d, torso(p, half), 0.16);
  if (p.z < -1.7) d = blend(d, plinth(p), 0.05);
  return d;
}

}  // namespace penumbra::detail
