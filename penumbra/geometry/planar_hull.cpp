// SPDX-License-Identifier: MIT
#include "penumbra/geometry/planar_hull.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace penumbra {
namespace {

bool is_left_of(PlanePoint a, PlanePoint b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

/// Half of the hull, from the first point to the last, without the last.
template <typename Iterator>
void add_chain(Iterator first, Iterator last, std::vector<PlanePoint>& ring) {
  const std::size_t start = ring.size();
  for (; first != last; ++first) {
    while (ring.size() >= start + 2 &&
           !(twice_area(ring[ring.size() - 2], ring[ring.size() - 1], *first) > 0))
      ring.pop_back();
    ring.push_back(*first);
  }
  ring.pop_back();
}

/// Of the triangle that corner i makes with its neighbours.
double area_at(std::span<const PlanePoint> ring, std::size_t i) {
  const std::size_t n = ring.size();
  return 0.5 * twice_area(ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]);
}

/// How far corner i stands out over the line through its neighbours.
double height_at(std::span<const PlanePoint> ring, std::size_t i) {
  const std::size_t n = ring.size();
  const PlanePoint a = ring[(i + n - 1) % n], b = ring[(i + 1) % n];
  const double base = std::hypot(b.x - a.x, b.y - a.y);
  return base > 0 ? 2 * area_at(ring, i) / base : 0;
}

PlanePoint middle_of(std::span<const PlanePoint> ring) {
  PlanePoint sum;
  for (const PlanePoint p : ring) sum.x += p.x, sum.y += p.y;
  const auto n = static_cast<double>(ring.size());
  return {sum.x / n, sum.y / n};
}

}  // namespace

std::vector<PlanePoint> planar_hull(std::vector<PlanePoint> points) {
  std::sort(points.begin(), points.end(), is_left_of);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<PlanePoint> ring;
  add_chain(points.begin(), points.end(), ring);
  add_chain(points.rbegin(), points.rend(), ring);
  return ring;
}

double area(std::span<const PlanePoint> ring) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    twice += twice_area(ring[0], ring[i], ring[i + 1]);
  return 0.5 * twice;
}

std::vector<PlanePoint> fewer_corners(std::vector<PlanePoint> ring, std::size_t most,
                                      double slack) {
  for (std::size_t i = 0; i < ring.size() && ring.size() > 3;)
    if (height_at(ring, i) <= slack)
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
    else
      ++i;
  const double before = area(ring);
  const std::size_t corners = ring.size();
  while (ring.size() > std::max<std::size_t>(most, 3)) {
    std::size_t least = 0;
    for (std::size_t i = 1; i < ring.size(); ++i)
      if (area_at(ring, i) < area_at(ring, least)) least = i;
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(least));
  }
  const double after = area(ring);
  if (ring.size() == corners || !(after > 0)) return ring;
  const double scale = std::sqrt(before / after);
  const PlanePoint middle = middle_of(ring);
  for (PlanePoint& p : ring)
    p = {middle.x + (p.x - middle.x) * scale, middle.y + (p.y - middle.y) * scale};
  return ring;
}

}  // namespace penumbra
