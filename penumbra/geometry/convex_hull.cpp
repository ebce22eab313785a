// SPDX-License-Identifier: MIT
#include "penumbra/geometry/convex_hull.h"

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include <algorithm>
#include <cstdio>
#include <utility>
#include <vector>

#include "penumbra/geometry/box.h"
#include "penumbra/geometry/centroid.h"
#include "penumbra/geometry/mesh.h"

namespace penumbra {
namespace {

/// Three coordinates a point, moved and scaled into the unit cube, which Qhull's tolerances suit.
std::vector<double> scaled(std::span<const Vec3f> points) {
  Box box;
  for (const Vec3f p : points) box.add(p);
  const Vec3d lo(box.lo);
  const double size = max_abs(Vec3d(box.hi) - lo);
  std::vector<double> coordinates;
  for (const Vec3f p : points) {
    const Vec3d q = (Vec3d(p) - lo) / size;
    coordinates.insert(coordinates.end(), {q.x, q.y, q.z});
  }
  return coordinates;
}

/// A run of Qhull: what it allocates, and where its messages go.
class Run {
 public:
  /// `coordinates` must outlive the run.
  explicit Run(std::vector<double>& coordinates) : messages_(std::fopen("/dev/null", "w")) {
    qh_zero(&qhull_, messages_);
    // Qt: facets of more than three corners are cut into triangles.
    char command[] = "qhull Qt Pp";
    is_done_ = messages_ != nullptr &&
               qh_new_qhull(&qhull_, 3, static_cast<int>(coordinates.size() / 3),
                            coordinates.data(), False, command, nullptr, messages_) == 0;
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;
  ~Run() {
    qh_freeqhull(&qhull_, !qh_ALL);
    int left = 0, blocks = 0;
    qh_memfreeshort(&qhull_, &left, &blocks);
    if (messages_ != nullptr) std::fclose(messages_);
  }

  /// Consistently outwards or consistently inwards; none where Qhull found no volume.
  std::vector<Triangle> triangles() {
    std::vector<Triangle> result;
    if (!is_done_) return result;
    // The list ends with a facet that is none.
    for (const facetT* f = qhull_.facet_list; f != nullptr && f->next != nullptr; f = f->next) {
      Triangle t{};
      for (int i = 0; i < 3; ++i) {
        const auto* vertex = static_cast<const vertexT*>(f->vertices->e[i].p);
        t[i] = static_cast<std::uint32_t>(qh_pointid(&qhull_, vertex->point));
      }
      if (!f->toporient) std::swap(t[1], t[2]);
      result.push_back(t);
    }
    return result;
  }

 private:
  std::FILE* messages_;
  qhT qhull_{};
  bool is_done_ = false;
};

std::vector<Triangle> hull_triangles(std::span<const Vec3f> points) {
  std::vector<double> coordinates = scaled(points);
  std::vector<Triangle> triangles = Run(coordinates).triangles();
  if (six_volumes(points, triangles) < 0)
    for (Triangle& t : triangles) std::swap(t[1], t[2]);
  return triangles;
}

/// The points that triangles use, in their order.
std::vector<Vec3f> used_points(std::span<const Vec3f> points, std::span<const Triangle> triangles) {
  std::vector<bool> is_used(points.size());
  for (const Triangle& t : triangles)
    for (const std::uint32_t corner : t) is_used[corner] = true;
  std::vector<Vec3f> used;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (is_used[i]) used.push_back(points[i]);
  return used;
}

}  // namespace

std::optional<MeshLight> convex_hull(std::span<const Vec3f> points) {
  if (points.size() < 4) return std::nullopt;
  if (!std::all_of(points.begin(), points.end(), [](Vec3f p) { return is_finite(p); }))
    return std::nullopt;
  // Again for the corners alone, until all are used: how Qhull cuts facets into triangles depends
  // on what it is given.
  MeshLight light{{}, {points.begin(), points.end()}, {}};
  for (;;) {
    light.triangles = hull_triangles(light.corners);
    if (light.triangles.empty()) return std::nullopt;
    std::vector<Vec3f> used = used_points(light.corners, light.triangles);
    if (used.size() == light.corners.size()) break;
    light.corners = std::move(used);
    if (light.corners.size() < 4) return std::nullopt;
  }
  light.center = volume_centroid(light.corners, light.triangles);
  return light;
}

}  // namespace penumbra
