// SPDX-License-Identifier: MIT
#include "penumbra/shadow/inner_volumes.h"

#include <algorithm>
#include <utility>

#include "penumbra/geometry/separation.h"
#include "penumbra/kernel/kernel.h"
#include "penumbra/kernel/traverse.h"
#include "penumbra/shadow/body_cover.h"
#include "penumbra/shadow/flat_hull.h"
#include "penumbra/shadow/light_clearance.h"

namespace penumbra {
namespace {

constexpr std::size_t fills_in_group = 16;

/// Twice what the intersector promises for triangles: 64 ulp of the farthest coordinate from p.
constexpr double hit_margin = 0x1p-17;

/// Whether the products that the intersector makes, and its rays' lengths, stay in float's range.
bool is_in_range(double reach, const LightShaft& shaft) {
  return reach > 1e-9 && reach < 1e9 && length(shaft.c - shaft.p) + shaft.light.size() < 1e15;
}

double reach_of(const Box& box, Vec3d p) {
  return std::max(max_abs(Vec3d(box.lo) - p), max_abs(Vec3d(box.hi) - p));
}

Box box_of(const InnerVolume& volume) {
  Vec3d lo = volume.center, hi = volume.center;
  for (const ConvexPolyhedron::Edge& edge : volume.body.edges)
    for (const Vec3d corner : {edge.a, edge.b})
      lo = min(lo, volume.center + corner), hi = max(hi, volume.center + corner);
  return outward(lo, hi);
}

/// The point of the segment from p to c that is nearest to x.
Vec3d nearest_on_axis(const LightShaft& shaft, Vec3d x) {
  const Vec3d way = shaft.c - shaft.p;
  const double t = dot(x - shaft.p, way) / length_squared(way);
  return shaft.p + way * std::clamp(t, 0.0, 1.0);
}

template <class Hull>
bool misses(const LightShaft& shaft, const Hull& hull, Vec3d middle, double margin) {
  return surely_apart(shaft, hull, nearest_on_axis(shaft, middle) - middle, margin);
}

}  // namespace

InnerVolumes::InnerVolumes(const ShapeSet& shapes, const std::vector<bool>& casts_no_shadow,
                           std::span<const LightHull> lights, const MeshSolidOptions& options) {
  for (MeshSolid& solid : mesh_solids(shapes.meshes, casts_no_shadow, options))
    add(std::move(solid), lights);
  std::vector<Box> boxes;
  for (const Volume& volume : volumes_) boxes.push_back(box_of(volume.inner));
  BoxTree tree = build_box_tree(boxes);
  std::vector<Volume> ordered;
  for (const std::uint32_t i : tree.order) ordered.push_back(std::move(volumes_[i]));
  volumes_ = std::move(ordered);
  nodes_ = std::move(tree.nodes);
}

void InnerVolumes::add(MeshSolid from, std::span<const LightHull> lights) {
  Solid solid{from.surface.box, {}, {}};
  for (const LightHull& light : lights)
    solid.clearance.push_back(light_clearance(from.surface, light));
  for (std::span<const FlatTriangle> rest = from.surface.fills(); !rest.empty();) {
    const auto group = rest.first(std::min(rest.size(), fills_in_group));
    solid.fills.push_back({bounds(group), {group.begin(), group.end()}});
    rest = rest.subspan(group.size());
  }
  for (InnerVolume& volume : from.volumes)
    volumes_.push_back({std::move(volume), static_cast<std::uint32_t>(solids_.size())});
  solids_.push_back(std::move(solid));
}

struct InnerVolumes::Query {
  std::uint32_t light;
  LightShaft shaft;
  ShaftWidth width;
  double doubt;
};

bool InnerVolumes::covers(const Volume& volume, const Query& query) const {
  if (!query.width.may_fit(volume.inner.center, volume.inner.body.outer)) return false;
  const LightShaft& shaft = query.shaft;
  const double doubt = query.doubt;
  const Solid& solid = solids_[volume.solid];
  const double reach = reach_of(solid.box, shaft.p), margin = hit_margin * reach;
  if (!is_in_range(reach, shaft)) return false;
  if (!(solid.clearance[query.light] > margin + doubt)) return false;
  // A sun's disk stands beyond the solid.
  if (shaft.light.is_sun() && !(2 * reach < length(shaft.c - shaft.p))) return false;
  if (!body_covers(volume.inner.body, volume.inner.center, shaft, margin, doubt)) return false;
  return std::all_of(solid.fills.begin(), solid.fills.end(), [&](const FillGroup& group) {
    const Vec3d middle(group.box.center());
    if (misses(shaft, BoxHull(group.box), middle, margin + doubt)) return true;
    return std::all_of(group.fills.begin(), group.fills.end(), [&](const FlatTriangle& fill) {
      return misses(shaft, FlatHull(fill), Vec3d(fill.a), margin + doubt);
    });
  });
}

VolumeAnswer InnerVolumes::covering(std::uint32_t light, const LightHull& hull, Vec3f p,
                                    std::uint32_t first) const {
  VolumeAnswer answer;
  const LightShaft shaft(hull, p);
  const Query query{light, shaft, ShaftWidth(shaft), hull.doubt(p)};
  const auto proves = [&](std::uint32_t i) {
    ++answer.tests;
    if (!covers(volumes_[i], query)) return false;
    answer.volume = i;
    return true;
  };
  if (first < volumes_.size() && proves(first)) return answer;
  Ray ray{p, Vec3f(shaft.c - shaft.p)};
  ray.t_max = 1;
  walk(nodes_, ray, [&](std::uint32_t start, std::uint32_t count) {
    for (std::uint32_t i = start; i < start + count; ++i)
      if (i != first && proves(i)) return true;
    return false;
  });
  return answer;
}

std::size_t InnerVolumes::memory_bytes() const {
  std::size_t sum = nodes_.capacity() * sizeof(WideNode) + volumes_.capacity() * sizeof(Volume) +
                    solids_.capacity() * sizeof(Solid);
  for (const Volume& volume : volumes_)
    sum += volume.inner.body.faces.capacity() * sizeof(HalfSpace) +
           volume.inner.body.edges.capacity() * sizeof(ConvexPolyhedron::Edge);
  for (const Solid& solid : solids_) {
    sum += solid.clearance.capacity() * sizeof(double);
    for (const FillGroup& group : solid.fills)
      sum += sizeof group + group.fills.capacity() * sizeof(FlatTriangle);
  }
  return sum;
}

}  // namespace penumbra
