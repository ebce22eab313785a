// SPDX-License-Identifier: MIT
#include "penumbra/visibility/scene_occluders.h"

#include <memory>
#include <utility>
#include <vector>

namespace penumbra {
namespace {

/// Leaves out what casts no shadow.
void keep_blockers(ShapeSet& shapes, const std::vector<Material>& materials) {
  const auto casts_none = [&](std::uint32_t surface) { return !materials[surface].casts_shadow; };
  const auto casts_none_itself = [&](const auto& shape) { return casts_none(shape.surface); };
  std::erase_if(shapes.spheres, casts_none_itself);
  std::erase_if(shapes.cones, casts_none_itself);
  std::erase_if(shapes.rings, casts_none_itself);
  for (Mesh& mesh : shapes.meshes) {
    std::vector<Triangle> kept;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
      if (!casts_none(surface_of(mesh, i))) kept.push_back(mesh.triangles[i]);
    Mesh blockers;
    blockers.positions = std::move(mesh.positions);
    blockers.triangles = std::move(kept);
    mesh = std::move(blockers);
  }
  std::erase_if(shapes.meshes, [](const Mesh& mesh) { return mesh.triangles.empty(); });
  for (ShapeSet& group : shapes.groups) keep_blockers(group, materials);
}

/// One member of each of many structs, as rows.
template <class Row, class Shape>
Rows<Row> rows(const std::vector<Shape>& shapes, const Row Shape::*member) {
  return shapes.empty() ? Rows<Row>()
                        : Rows<Row>(&(shapes.front().*member), shapes.size(), sizeof(Shape));
}

void add_cones(const std::vector<Cone>& cones, Caps caps, Occluders& to) {
  if (cones.empty()) return;
  to.add_cones(rows(cones, &Cone::base), rows(cones, &Cone::apex), rows(cones, &Cone::base_radius),
               rows(cones, &Cone::apex_radius), caps);
}

/// The shapes of one set, cones by their caps.
struct SplitShapes {
  ShapeSet shapes;
  std::vector<Cone> open, capped;

  explicit SplitShapes(ShapeSet set) : shapes(std::move(set)) {
    for (const Cone& cone : shapes.cones) (cone.caps == Caps::open ? open : capped).push_back(cone);
  }

  void add_to(Occluders& to) const {
    if (!shapes.spheres.empty())
      to.add_spheres(rows(shapes.spheres, &Sphere::center), rows(shapes.spheres, &Sphere::radius));
    add_cones(open, Caps::open, to);
    add_cones(capped, Caps::capped, to);
    if (!shapes.rings.empty())
      to.add_disks(rows(shapes.rings, &Ring::center), rows(shapes.rings, &Ring::normal),
                   rows(shapes.rings, &Ring::radius), rows(shapes.rings, &Ring::inner_radius));
    for (const Mesh& mesh : shapes.meshes)
      to.add_triangles(std::span(mesh.positions), std::span(mesh.triangles));
  }
};

}  // namespace

Occluders occluders_of(const Scene& scene) {
  ShapeSet shapes = scene.shapes;
  keep_blockers(shapes, scene.materials);
  Occluders occluders;
  for (ShapeSet& group : std::exchange(shapes.groups, {})) {
    const auto split = std::make_shared<const SplitShapes>(std::move(group));
    Occluders of_group;
    split->add_to(of_group);
    occluders.add_group(of_group);
    occluders.keep(split);
  }
  for (const Instance& instance : shapes.instances)
    occluders.add_instance({instance.group}, instance.placement);
  const auto split = std::make_shared<const SplitShapes>(std::move(shapes));
  split->add_to(occluders);
  occluders.keep(split);
  occluders.commit();
  return occluders;
}

}  // namespace penumbra
