// SPDX-License-Identifier: MIT
// A light as the proofs see it: a centre c and the convex set L - c around it. Samples that float
// has rounded off the light are covered by `doubt`.
#pragma once

#include <span>
#include <vector>

#include "penumbra/geometry/box.h"
#include "penumbra/geometry/light_shape.h"
#include "penumbra/geometry/vec.h"

namespace penumbra {

/// Below this length squares leave float's range: the intersector may hit what is so near, and
/// nothing so small is proven.
inline constexpr double underflow_bound = 1e-18;

/// The intersector divides lengths by those of rays: where a ray is so many times longer than what
/// it may meet is far, float's range may not suffice, and nothing is proven.
inline constexpr double greatest_ratio = 1e9;

/// A box in double.
struct ExtentBox {
  Vec3d lo, hi;
  /// The largest a . x.
  double most(Vec3d a) const {
    const Vec3d at_lo(a.x * lo.x, a.y * lo.y, a.z * lo.z),
        at_hi(a.x * hi.x, a.y * hi.y, a.z * hi.z);
    const Vec3d best = max(at_lo, at_hi);
    return best.x + best.y + best.z;
  }
  double least(Vec3d a) const { return -most(-a); }
};

/// Prepared once a light. Where p is an argument it is a receiver point p'.
///
/// A sun is no set of points: for each p it becomes the disk across its direction, so far from p
/// that nothing of the scene lies behind it (`reach`, for all p in the scene's box). Its rays are
/// those from p to that disk, and all that is proven of finite lights holds for it.
class LightHull {
 public:
  /// `scene`: a box that holds all shapes. Cost: linear in the light's corners.
  LightHull(const LightShape& light, const Box& scene);

  /// c; for suns p + reach * direction.
  Vec3d center(Vec3f p) const { return is_sun_ ? Vec3d(p) + center_ : center_; }

  /// The farthest point of L - c along n (any length; 0 gives some point of it). L - c may be
  /// rounded up: dot(spread(n), n) is not below the exact support but for errors of double.
  Vec3d spread(Vec3d n) const;

  /// n . spread(n): how far L - c reaches along n.
  double extent(Vec3d n) const { return is_ball() ? length(n) * size_ : dot(n, spread(n)); }

  /// The largest |l - c|.
  double size() const { return size_; }

  /// Length by which samples seen from p may lie off the light: twice what `sample_light` promises,
  /// at least.
  double doubt(Vec3f p) const;
  /// The same for a known |c - p|.
  double doubt(Vec3f p, double distance) const {
    return 0x1p-20 * (1.75 * double(max_abs(p)) + distance + 2 * size_);
  }

  /// The box of L - c.
  const ExtentBox& spread_box() const { return spread_box_; }

  /// Lower bound of n . (l - p) over all samples l that p can be given, rounding included.
  double least_height(Vec3f p, Vec3d n) const;

  /// Points whose hull holds L - c: its corners; those of a polygon around a disk or a sun. Empty
  /// for balls.
  std::span<const Vec3d> corners() const { return corners_; }

  bool is_ball() const { return corners_.empty(); }
  bool is_sun() const { return is_sun_; }
  /// Disks, and suns as disks; `normal` is theirs, unit.
  bool is_disk() const { return is_disk_; }
  Vec3d normal() const { return normal_; }

 private:
  void set_shape(const LightShape& light, const Box& scene);
  Vec3d center_;  // suns: reach * direction
  double size_ = 0;
  bool is_sun_ = false, is_disk_ = false;
  Vec3d normal_;  // of disks and suns, unit
  std::vector<Vec3d> corners_;
  ExtentBox spread_box_;
};

/// L, around the centre c.
struct LightSet {
  const LightHull& light;
  Vec3d c;
  Vec3d support(Vec3d n) const { return c + light.spread(n); }
};

/// The shaft from p to the light: the hull of p and L. It holds every segment to a sample, up to
/// `doubt`.
struct LightShaft {
  const LightHull& light;
  Vec3d p, c;
  LightShaft(const LightHull& l, Vec3f point) : light(l), p(point), c(l.center(point)) {}
  /// Farthest point along n.
  Vec3d support(Vec3d n) const {
    const Vec3d far = c + light.spread(n);
    return dot(far - p, n) > 0 ? far : p;
  }
};

/// The segment from p to c, thickened by t (L - c). It meets an occluder Q exactly where the
/// segment meets the outer offset Q ⊖ t (L ⊖ c) (paper, Definition 1-2, Eq. 1-4).
struct ThickSegment {
  const LightHull& light;
  Vec3d p, c;
  double t;  ///< in [0, 1]
  ThickSegment(const LightHull& l, Vec3f point, double t_)
      : light(l), p(point), c(l.center(point)), t(t_) {}
  Vec3d support(Vec3d n) const { return (dot(c - p, n) > 0 ? c : p) + light.spread(n) * t; }
};

}  // namespace penumbra
