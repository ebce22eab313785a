// SPDX-License-Identifier: MIT
#include "penumbra/visibility/gather.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "penumbra/geometry/placed_shape.h"
#include "penumbra/scene/coordinates.h"
#include "penumbra/scene/error.h"
#include "penumbra/scene/settle_instances.h"

namespace penumbra {
namespace {

constexpr const char* coordinate_hint = "mend the number, or scale the scene";

/// One geometry, read into a set of shapes.
class Reader {
 public:
  /// `where`: what errors begin with, such as "group 2, ".
  Reader(const GeometryRows& rows, std::uint32_t number, const std::string& where, ShapeSet& to,
         ShapeNames& names)
      : rows_(rows), number_(number), where_(where), to_(to), names_(names) {}

  /// Returns how many degenerate triangles were left out.
  std::size_t read() {
    switch (rows_.kind) {
      case ShapeKind::sphere: read_spheres(); return 0;
      case ShapeKind::cone: read_cones(); return 0;
      case ShapeKind::ring: read_rings(); return 0;
      case ShapeKind::triangle: break;
    }
    return read_mesh();
  }

 private:
  [[noreturn]] void fail(const char* thing, std::size_t i, const char* what,
                         const char* hint) const {
    throw Error({}, fmt::format("{}geometry {}: {} {} {}", where_, number_, thing, i, what), hint);
  }
  void require(bool holds, const char* thing, std::size_t i, const char* what,
               const char* hint) const {
    if (!holds) fail(thing, i, what, hint);
  }
  void require_position(Vec3f p, const char* thing, std::size_t i) const {
    require(is_coordinate(p), thing, i, "has a coordinate that is not a number within ±1e15",
            coordinate_hint);
  }
  void begin_run(ShapeKind kind, std::size_t first) {
    names_.runs[static_cast<int>(kind)].push_back({static_cast<std::uint32_t>(first), number_});
  }

  void read_spheres() {
    begin_run(ShapeKind::sphere, to_.spheres.size());
    for (std::size_t i = 0; i < rows_.positions.size(); ++i) {
      const Sphere sphere{rows_.positions[i], rows_.radii[i]};
      require_position(sphere.center, "sphere", i);
      require(is_radius(sphere.radius), "sphere", i, "has a radius that is not above 0",
              "give it a size, or leave it out");
      to_.spheres.push_back(sphere);
    }
  }

  void read_cones() {
    begin_run(ShapeKind::cone, to_.cones.size());
    const auto is_size = [](float r) { return r == 0 || is_radius(r); };
    for (std::size_t i = 0; i < rows_.positions.size(); ++i) {
      const Cone cone{rows_.positions[i], rows_.directions[i], rows_.radii[i], rows_.other_radii[i],
                      rows_.caps};
      require_position(cone.base, "cone", i);
      require_position(cone.apex, "cone", i);
      require(is_size(cone.base_radius) && is_size(cone.apex_radius) &&
                  (cone.base_radius > 0 || cone.apex_radius > 0),
              "cone", i, "has a radius that is negative or no number, or two that are 0",
              "give it a size, or leave it out");
      require(cone.base != cone.apex, "cone", i, "has its base where its apex is",
              "give it a length, or leave it out");
      to_.cones.push_back(cone);
    }
  }

  void read_rings() {
    begin_run(ShapeKind::ring, to_.rings.size());
    for (std::size_t i = 0; i < rows_.positions.size(); ++i) {
      const float inner = rows_.other_radii.empty() ? 0 : rows_.other_radii[i];
      const Ring ring{rows_.positions[i], unit(rows_.directions[i]), rows_.radii[i], inner};
      require_position(ring.center, "disk", i);
      require(ring.normal != Vec3f{}, "disk", i, "has no normal", "give it a direction");
      require(is_radius(ring.radius) && inner >= 0 && inner < ring.radius, "disk", i,
              "has a radius that is not above 0 and above its inner radius",
              "give it a size, or leave it out");
      to_.rings.push_back(ring);
    }
  }

  std::size_t read_mesh() {
    Mesh mesh;
    mesh.positions.reserve(rows_.positions.size());
    for (std::size_t i = 0; i < rows_.positions.size(); ++i) {
      mesh.positions.push_back(rows_.positions[i]);
      require_position(mesh.positions.back(), "vertex", i);
    }
    ShapeNames::MeshName name{number_, {}};
    mesh.triangles.reserve(rows_.triangles.size());
    std::vector<std::uint32_t> dropped;
    for (std::size_t i = 0; i < rows_.triangles.size(); ++i) {
      const Triangle triangle = rows_.triangles[i];
      for (const std::uint32_t corner : triangle)
        require(corner < mesh.positions.size(), "triangle", i, "has a vertex that does not exist",
                "number vertices from 0");
      if (is_degenerate(mesh, triangle))
        dropped.push_back(static_cast<std::uint32_t>(i));
      else
        mesh.triangles.push_back(triangle);
    }
    if (!dropped.empty()) name.kept = all_but(dropped, rows_.triangles.size());
    if (mesh.triangles.empty()) return dropped.size();
    to_.meshes.push_back(std::move(mesh));
    names_.meshes.push_back(std::move(name));
    return dropped.size();
  }

  /// Rising numbers below `count` but for some, rising as well.
  static std::vector<std::uint32_t> all_but(const std::vector<std::uint32_t>& some,
                                            std::size_t count) {
    std::vector<std::uint32_t> others;
    others.reserve(count - some.size());
    auto next = some.begin();
    for (std::uint32_t i = 0; i < count; ++i)
      if (next != some.end() && *next == i)
        ++next;
      else
        others.push_back(i);
    return others;
  }

  const GeometryRows& rows_;
  std::uint32_t number_;
  const std::string& where_;
  ShapeSet& to_;
  ShapeNames& names_;
};

std::size_t read_all(const Numbered<GeometryRows>& geometries, const std::string& where,
                     ShapeSet& to, ShapeNames& names) {
  std::size_t degenerate = 0;
  for (std::uint32_t i = 0; i < geometries.size(); ++i)
    if (geometries[i]) degenerate += Reader(*geometries[i], i, where, to, names).read();
  return degenerate;
}

void check_placement(const Transform& map, const ShapeSet& group, std::uint32_t number) {
  const auto require = [&](bool holds, const char* what, const char* hint) {
    if (!holds) throw Error({}, fmt::format("instance {} {}", number, what), hint);
  };
  require(is_coordinate(map.offset) && can_place(map),
          "has a placement that flattens, or numbers below 1e-15 or beyond 1e15", coordinate_hint);
  require(!has_quadrics(group) || similarity_scale(map) > 0, "stretches spheres, cones or disks",
          "scale them alike in all directions, or use meshes");
}

/// Reads what instances place, each group once.
void read_instances(const Description& description, GatheredShapes& to) {
  constexpr std::uint32_t unread = 0xffffffffu;
  std::vector<std::uint32_t> set_of(description.groups.size(), unread);
  for (std::uint32_t i = 0; i < description.instances.size(); ++i) {
    const std::optional<Instance>& instance = description.instances[i];
    if (!instance) continue;
    std::uint32_t& set = set_of[instance->group];
    if (set == unread) {
      set = static_cast<std::uint32_t>(to.shapes.groups.size());
      to.degenerate_triangles +=
          read_all(*description.groups[instance->group], fmt::format("group {}, ", instance->group),
                   to.shapes.groups.emplace_back(), to.names.groups.emplace_back());
    }
    check_placement(instance->placement, to.shapes.groups[set], i);
    if (own_primitive_count(to.shapes.groups[set]) == 0) continue;
    to.shapes.instances.push_back({set, instance->placement});
    to.names.instances.push_back({i, set});
  }
}

constexpr std::size_t most_primitives = (std::size_t{1} << 27) - 1;

void require_few(std::size_t primitives) {
  if (primitives > most_primitives)
    throw Error({}, "the occluders are more than 2^27 primitives", "split the scene");
}

/// Before anything is made of them: rows may be as many as one likes, where all are one.
void check_counts(const Numbered<GeometryRows>& geometries) {
  std::size_t primitives = 0, vertices = 0;
  for (const std::optional<GeometryRows>& rows : geometries) {
    if (!rows) continue;
    const bool is_mesh = rows->kind == ShapeKind::triangle;
    primitives += is_mesh ? rows->triangles.size() : rows->positions.size();
    vertices += is_mesh ? rows->positions.size() : 0;
  }
  require_few(primitives);
  if (vertices > 3 * most_primitives)
    throw Error({}, "the occluders have more than 3 * 2^27 vertices", "split the scene");
}

/// What is over all of it.
void check_whole(const ShapeSet& shapes) {
  require_few(primitive_count(shapes));
  const Box box = bounds(shapes);
  if (!box.is_empty() && !(is_coordinate(box.lo) && is_coordinate(box.hi)))
    throw Error({}, "an instance reaches beyond 1e15", coordinate_hint);
}

}  // namespace

GatheredShapes gather(const Description& description) {
  check_counts(description.geometries);
  for (const auto& group : description.groups)
    if (group) check_counts(*group);
  GatheredShapes gathered;
  gathered.degenerate_triangles =
      read_all(description.geometries, "", gathered.shapes, gathered.names.own);
  read_instances(description, gathered);
  check_whole(gathered.shapes);
  return gathered;
}

PrimitiveId name_of(const OccluderNames& all, ShapeRef ref) {
  PrimitiveId id;
  const ShapeNames* names = &all.own;
  if (ref.instance > 0) {
    const OccluderNames::InstanceName& instance = all.instances[ref.instance - 1];
    id.instance = instance.number;
    names = &all.groups[instance.group];
  }
  if (ref.kind == ShapeKind::triangle) {
    const ShapeNames::MeshName& mesh = names->meshes[ref.index];
    id.geometry = mesh.geometry;
    id.primitive = mesh.kept.empty() ? ref.triangle : mesh.kept[ref.triangle];
    return id;
  }
  const auto& runs = names->runs[static_cast<int>(ref.kind)];
  const auto after = std::upper_bound(
      runs.begin(), runs.end(), ref.index,
      [](std::uint32_t index, const ShapeNames::Run& run) { return index < run.first; });
  id.geometry = after[-1].geometry;
  id.primitive = ref.index - after[-1].first;
  return id;
}

}  // namespace penumbra
