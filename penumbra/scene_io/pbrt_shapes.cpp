// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/pbrt_shapes.h"

#include <algorithm>
#include <utility>

#include "penumbra/scene_io/numbers.h"

namespace penumbra {
namespace {

/// Whether the shape is there: pbrt's alpha of 0 is nothing at all, but for the light it sends out.
bool is_visible(PbrtScene& pbrt, const PbrtParams& params) {
  const PbrtParameter* alpha = params.find("alpha");
  if (!alpha) return true;
  const double constant = alpha->type == "texture" ? 0.5 : params.number("alpha", 1);
  if (constant <= 0 || constant >= 1) return constant > 0;
  pbrt.warnings.add("alpha is not read: see-through parts are drawn opaque", alpha->place);
  return true;
}

/// Twice the area vectors of the corners' normals and of the triangle: negative when they disagree.
double agreement(const Mesh& mesh, const Triangle& t) {
  const Vec3d a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
  Vec3d normal;
  for (const std::uint32_t corner : t) normal += Vec3d(mesh.normals[corner]);
  return dot(cross(b - a, c - a), normal);
}

/// Outside is where the normals point, and where ReverseOrientation turns it.
void orient(Mesh& mesh, bool is_reversed) {
  if (is_reversed)
    for (Vec3f& normal : mesh.normals) normal = -normal;
  for (Triangle& t : mesh.triangles)
    if (mesh.normals.empty() ? is_reversed : agreement(mesh, t) < 0) std::swap(t[1], t[2]);
}

void charge(std::size_t& left, std::size_t cost, PbrtPlace place) {
  if (cost > left)
    throw Error(place, "the scene makes more triangles than fit into memory", "split the scene");
  left -= cost;
}

}  // namespace

std::uint32_t pbrt_surface(PbrtScene& pbrt, const std::optional<PbrtGlow>& glow,
                           bool casts_shadow) {
  const std::uint32_t base = pbrt.graphics.material;
  if (!glow) return base;
  const PbrtMaterialSlot& last = pbrt.materials.back();
  if (last.base != base || last.emission != glow->radiance ||
      last.is_two_sided != glow->is_two_sided || last.casts_shadow != casts_shadow) {
    PbrtMaterialSlot slot;
    slot.base = base;
    slot.emission = glow->radiance;
    slot.is_two_sided = glow->is_two_sided;
    slot.casts_shadow = casts_shadow;
    pbrt.materials.push_back(std::move(slot));
  }
  return static_cast<std::uint32_t>(pbrt.materials.size() - 1);
}

void charge_made(PbrtScene& pbrt, std::size_t cost, PbrtPlace place) {
  charge(pbrt.made_left, cost, place);
}

int pbrt_segments(const PbrtScene& pbrt) {
  constexpr std::size_t many = std::size_t{1} << 21;
  return pbrt.graphics.area_light || pbrt.made_left < many ? 16 : 64;
}

void add_pbrt_mesh(PbrtScene& pbrt, Mesh mesh, PbrtMeshOrigin origin, PbrtPlace place,
                   std::size_t lights) {
  const std::size_t cost = mesh.positions.size() + mesh.triangles.size();
  charge(pbrt.corners_left, cost, place);
  if (origin == PbrtMeshOrigin::made) charge_made(pbrt, cost, place);
  mesh = transformed(std::move(mesh), pbrt.graphics.to_world);
  orient(mesh, pbrt.graphics.is_reversed);
  if (mesh.triangles.empty()) return;
  if (lights == 0) lights = mesh.triangles.size();
  mesh.surface = pbrt_surface(pbrt, pbrt_glow(pbrt, area(mesh), lights), true);
  pbrt_target(pbrt).meshes.push_back(std::move(mesh));
}

void add_pbrt_shape(PbrtScene& pbrt, const PbrtDefinition& definition) {
  using Add = void (*)(PbrtScene&, const PbrtParams&);
  struct Kind {
    std::string_view name;
    Add add;
  };
  constexpr Kind kinds[] = {{"sphere", add_pbrt_sphere},   {"cylinder", add_pbrt_cylinder},
                            {"disk", add_pbrt_disk},       {"trianglemesh", add_pbrt_triangles},
                            {"plymesh", add_pbrt_ply},     {"bilinearmesh", add_pbrt_patches},
                            {"loopsubdiv", add_pbrt_loop}, {"curve", add_pbrt_curve}};
  const auto kind = std::find_if(std::begin(kinds), std::end(kinds),
                                 [&](const Kind& k) { return k.name == definition.kind; });
  if (kind == std::end(kinds))
    throw Error(definition.params.place(), "unknown shape " + in_quotes(definition.kind),
                "pbrt-v4 has sphere, cylinder, disk, trianglemesh, plymesh, bilinearmesh, "
                "loopsubdiv and curve");
  const bool is_seen = is_visible(pbrt, definition.params);
  if (!is_seen && !pbrt.graphics.area_light) return;
  ShapeSet& shapes = pbrt_target(pbrt);
  const std::size_t spheres = shapes.spheres.size(), rings = shapes.rings.size(),
                    others = shapes.meshes.size() + shapes.cones.size();
  kind->add(pbrt, definition.params);
  warn_unread(pbrt, "Shape", definition);
  if (is_seen) return;
  // Only its light is wanted, which spheres and disks already have given.
  shapes.spheres.resize(spheres);
  shapes.rings.resize(rings);
  if (shapes.meshes.size() + shapes.cones.size() > others)
    pbrt.warnings.add("a glowing mesh that alpha makes invisible is seen",
                      definition.params.place());
}

}  // namespace penumbra
