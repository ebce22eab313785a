// SPDX-License-Identifier: MIT
// Only corners that do not turn left can lie in an ear; they wait in a grid, so that usual outlines
// cost about linear time.
#include "penumbra/geometry/polygon_ears.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace penumbra {
namespace {

/// Buckets of points over their bounding rectangle, about one point a bucket.
class PointGrid {
 public:
  PointGrid(std::span<const PlanePoint> points, std::span<const std::uint32_t> members) {
    if (members.empty()) return;
    PlanePoint hi = low_ = points[members[0]];
    for (std::uint32_t m : members) {
      low_ = {std::min(low_.x, points[m].x), std::min(low_.y, points[m].y)};
      hi = {std::max(hi.x, points[m].x), std::max(hi.y, points[m].y)};
    }
    side_ = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(members.size()))));
    const auto scale = [&](double extent) { return extent > 0 ? side_ / extent : 0; };
    scale_ = {scale(hi.x - low_.x), scale(hi.y - low_.y)};
    start_.assign(static_cast<std::size_t>(side_) * side_ + 1, 0);
    for (std::uint32_t m : members) ++start_[cell(points[m]) + 1];
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    members_.resize(members.size());
    std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
    for (std::uint32_t m : members) members_[next[cell(points[m])]++] = m;
  }

  /// True if `is_hit` is true for a member near the rectangle. Adds what it looked at to `steps`.
  template <typename Predicate>
  bool any_in(PlanePoint lo, PlanePoint hi, std::uint64_t& steps, Predicate is_hit) const {
    if (members_.empty()) return false;
    const int x_end = column(hi.x), y_end = row(hi.y);
    for (int y = row(lo.y); y <= y_end; ++y)
      for (int x = column(lo.x); x <= x_end; ++x) {
        const std::size_t c = static_cast<std::size_t>(y) * side_ + x;
        steps += 1 + start_[c + 1] - start_[c];
        for (std::uint32_t i = start_[c]; i < start_[c + 1]; ++i)
          if (is_hit(members_[i])) return true;
      }
    return false;
  }

 private:
  int clamped(double v) const { return static_cast<int>(std::clamp(v, 0.0, side_ - 1.0)); }
  int column(double x) const { return clamped((x - low_.x) * scale_.x); }
  int row(double y) const { return clamped((y - low_.y) * scale_.y); }
  std::size_t cell(PlanePoint p) const {
    return static_cast<std::size_t>(row(p.y)) * side_ + column(p.x);
  }

  PlanePoint low_, scale_;
  int side_ = 1;
  std::vector<std::uint32_t> start_, members_;
};

/// The ring that is left, as a linked list over places in `points`.
class Ring {
 public:
  explicit Ring(std::vector<PlanePoint> points)
      : points_(std::move(points)), next_(points_.size()), previous_(next_), last_blocker_(next_) {
    const auto n = static_cast<std::uint32_t>(points_.size());
    for (std::uint32_t i = 0; i < n; ++i) next_[i] = (i + 1) % n, previous_[next_[i]] = i;
    std::vector<std::uint32_t> reflex;
    for (std::uint32_t i = 0; i < n; ++i)
      if (!(area(i) > 0)) reflex.push_back(i);
    reflex_ = PointGrid(points_, reflex);
  }

  std::uint32_t next(std::uint32_t i) const { return next_[i]; }
  std::uint32_t previous(std::uint32_t i) const { return previous_[i]; }

  double area(std::uint32_t i) const {
    return twice_area(points_[previous_[i]], points_[i], points_[next_[i]]);
  }

  void remove(std::uint32_t i) {
    next_[previous_[i]] = next_[i];
    previous_[next_[i]] = previous_[i];
    next_[i] = i;  // marks it
  }

  /// Hostile outlines must not take hours: the work is bounded, generously, by the input's size.
  bool is_tired() const { return steps_ > 10'000'000 + 10'000 * points_.size(); }

  /// The corner to cut off when there is no ear: the first left turn from here on, if any.
  std::uint32_t without_care(std::uint32_t from) {
    for (std::uint32_t i = from; !is_tired(); ++steps_) {
      if (area(i) > 0) return i;
      i = next_[i];
      if (i == from) break;
    }
    return from;
  }

  /// A left turn whose triangle holds nothing of the rest of the ring, its border included.
  bool is_ear(std::uint32_t i) {
    ++steps_;
    if (!(area(i) > 0)) return false;
    const PlanePoint a = points_[previous_[i]], b = points_[i], c = points_[next_[i]];
    const PlanePoint lo{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})};
    const PlanePoint hi{std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})};
    const auto is_in_the_way = [&](std::uint32_t j) {
      const bool is_corner = j == i || j == previous_[i] || j == next_[i];
      return next_[j] != j && !is_corner && blocks(j, a, b, c);
    };
    // Most often what was in the way last time still is.
    if (is_in_the_way(last_blocker_[i])) return false;
    return !reflex_.any_in(lo, hi, steps_, [&](std::uint32_t j) {
      if (!is_in_the_way(j)) return false;
      last_blocker_[i] = j;
      return true;
    });
  }

 private:
  bool blocks(std::uint32_t j, PlanePoint a, PlanePoint b, PlanePoint c) const {
    const PlanePoint p = points_[j];
    // Where the ring touches itself in a corner of the ear (a bridge to a hole does), only an edge
    // that leaves into the ear is in the way.
    if (p == a) return enters(j, a, b, c);
    if (p == b) return enters(j, b, c, a);
    if (p == c) return enters(j, c, a, b);
    return twice_area(a, b, p) >= 0 && twice_area(b, c, p) >= 0 && twice_area(c, a, p) >= 0;
  }

  /// An edge at j, which lies on the corner `at`, leads into the angle between `right` and `left`.
  bool enters(std::uint32_t j, PlanePoint at, PlanePoint right, PlanePoint left) const {
    const auto is_inside = [&](PlanePoint q) {
      return twice_area(at, right, q) > 0 && twice_area(left, at, q) > 0;
    };
    return is_inside(points_[next_[j]]) || is_inside(points_[previous_[j]]);
  }

  std::vector<PlanePoint> points_;
  std::vector<std::uint32_t> next_, previous_, last_blocker_;
  PointGrid reflex_{{}, {}};
  std::uint64_t steps_ = 0;
};

}  // namespace

std::vector<Triangle> clip_ears(std::span<const PlanePoint> points,
                                std::span<const std::uint32_t> corners) {
  std::vector<PlanePoint> places;
  places.reserve(corners.size());
  for (std::uint32_t corner : corners) places.push_back(points[corner]);
  Ring ring(std::move(places));

  std::vector<Triangle> triangles;
  std::uint32_t i = 0;
  std::size_t left = corners.size(), in_vain = 0;
  while (left >= 3) {
    const bool is_careful = !ring.is_tired() && in_vain < left;
    if (is_careful && !ring.is_ear(i)) {
      i = ring.next(i);
      ++in_vain;
      continue;
    }
    if (!is_careful) i = ring.without_care(i);
    const std::uint32_t before = ring.previous(i), after = ring.next(i);
    if (ring.area(i) != 0) triangles.push_back({corners[before], corners[i], corners[after]});
    ring.remove(i);
    --left, in_vain = 0;
    i = ring.next(after);  // not `after`: fans of slivers would come out
  }
  return triangles;
}

}  // namespace penumbra
