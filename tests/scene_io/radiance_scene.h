// SPDX-License-Identifier: MIT
// Radiance scenes in memory, and what is in them with all placements carried out.
#pragma once

#include <string>
#include <vector>

#include "penumbra/geometry/transform.h"
#include "penumbra/scene/scene.h"
#include "penumbra/scene_io/source.h"
#include "tests/scene_io/temporary_folder.h"
#include "tests/scene_io/text_source.h"

namespace penumbra {

/// A scene and the warnings that came with it. Validated.
struct RadianceRead {
  Scene scene;
  std::vector<std::string> warnings;

  bool warns_of(const std::string& part) const {
    for (const std::string& warning : warnings)
      if (holds(warning, part)) return true;
    return false;
  }
};

inline RadianceRead read_radiance_source(const Source& source) {
  Warnings warnings(source.path.string());
  RadianceRead read{read_radiance(source, warnings), {}};
  validate(read.scene);
  read.warnings = warnings.lines();
  return read;
}

/// A .rad text; a sphere is put behind it, since a scene without any shape is none.
inline RadianceRead read_rad(const std::string& text) {
  return read_radiance_source(source_of("t.rad", text + "\nvoid sphere far 0 0 4 900 0 0 1\n"));
}

inline std::string rad_error(const std::string& text) {
  return error_of([&] { read_rad(text); });
}

/// Everything but that sphere, placed.
inline ShapeSet all_placed(const Scene& scene) {
  ShapeSet all = scene.shapes;
  std::erase_if(all.spheres, [](const Sphere& s) { return s.center == Vec3f{900, 0, 0}; });
  const auto place = [](Vec3f p, const Transform& t) { return Vec3f(apply_point(t, Vec3d(p))); };
  for (const Instance& i : scene.shapes.instances) {
    const Transform& t = i.placement;
    const ShapeSet& group = scene.shapes.groups[i.group];
    const auto scale = static_cast<float>(length(t.x_axis));
    for (const Sphere& s : group.spheres)
      all.spheres.push_back({place(s.center, t), s.radius * scale, s.surface});
    for (Cone c : group.cones) {
      c.base = place(c.base, t), c.apex = place(c.apex, t);
      c.base_radius *= scale, c.apex_radius *= scale;
      all.cones.push_back(c);
    }
    for (Ring r : group.rings) {
      r.center = place(r.center, t);
      r.normal = Vec3f(normalize(apply_direction(t, Vec3d(r.normal))));
      r.radius *= scale, r.inner_radius *= scale;
      all.rings.push_back(r);
    }
    for (const Mesh& mesh : group.meshes) all.meshes.push_back(transformed(mesh, t));
  }
  return all;
}

inline double area(const Mesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles)
    sum += 0.5 * length(cross(Vec3d(mesh.positions[t[1]]) - Vec3d(mesh.positions[t[0]]),
                              Vec3d(mesh.positions[t[2]]) - Vec3d(mesh.positions[t[0]])));
  return sum;
}

/// Six times the volume that the mesh's triangles enclose with the origin, positive seen outwards.
inline double six_volume(const Mesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles)
    sum += dot(Vec3d(mesh.positions[t[0]]),
               cross(Vec3d(mesh.positions[t[1]]), Vec3d(mesh.positions[t[2]])));
  return sum;
}

}  // namespace penumbra
