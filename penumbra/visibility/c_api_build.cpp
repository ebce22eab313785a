// SPDX-License-Identifier: MIT
// The C API: what there is.
#include <mutex>

#include "penumbra/visibility/c_api_registry.h"
#include "penumbra/visibility/c_api_values.h"

namespace penumbra {
namespace {

/// Calls change(object) while no other call adds, updates or removes.
template <class Change>
penumbra_error change(const char* function, penumbra_occluders occluders, const Change& call) {
  return guarded(function, occluders, [&] {
    const std::shared_ptr<ApiObject> object = object_of(occluders);
    const std::lock_guard lock(object->parts_mutex);
    call(*object);
  });
}

/// Calls add(occluders), and gives its handle.
template <class Handle, class Add>
void add_part(ApiObject& object, Parts& parts, Handle* out, const Add& add) {
  check_pointer(out, "out");
  parts.reserve_one();
  const Handle handle{parts.give(add(object.occluders).index)};
  std::memcpy(static_cast<void*>(out), &handle, sizeof handle);
}

template <class Add>
penumbra_error add_geometry(const char* function, penumbra_occluders occluders,
                            penumbra_geometry* out, const Add& add) {
  return change(function, occluders,
                [&](ApiObject& object) { add_part(object, object.geometries, out, add); });
}

CommitOptions commit_options_of(const penumbra_commit_options* options) {
  if (!options) return {};
  const auto given = read_struct(options, "options");
  if (given.may_refit > 1) refuse_argument("options.may_refit is neither 0 nor 1");
  return {.may_refit = given.may_refit == 1};
}

}  // namespace

extern "C" {

uint32_t penumbra_c_api_version() { return PENUMBRA_C_API_VERSION; }

penumbra_error penumbra_create(penumbra_occluders* out) {
  return guarded(__func__, {}, [&] {
    check_pointer(out, "out");
    const penumbra_occluders made = make_object();
    std::memcpy(static_cast<void*>(out), &made, sizeof made);
  });
}

penumbra_error penumbra_release(penumbra_occluders occluders) {
  return guarded(__func__, occluders, [&] { release_object(occluders); });
}

penumbra_error penumbra_set_error_function(penumbra_occluders occluders,
                                           penumbra_error_function function, void* user) {
  return guarded(__func__, occluders, [&] { set_error_function(occluders, {function, user}); });
}

penumbra_error penumbra_add_triangles(penumbra_occluders occluders, penumbra_rows positions,
                                      penumbra_rows triangles, penumbra_geometry* out) {
  return add_geometry(__func__, occluders, out, [&](Occluders& to) {
    return to.add_triangles(rows_of<Vec3f>(positions, "positions"),
                            rows_of<std::array<std::uint32_t, 3>>(triangles, "triangles"));
  });
}

penumbra_error penumbra_add_spheres(penumbra_occluders occluders, penumbra_rows centers,
                                    penumbra_rows radii, penumbra_geometry* out) {
  return add_geometry(__func__, occluders, out, [&](Occluders& to) {
    return to.add_spheres(rows_of<Vec3f>(centers, "centers"), rows_of<float>(radii, "radii"));
  });
}

penumbra_error penumbra_add_cones(penumbra_occluders occluders, penumbra_rows bases,
                                  penumbra_rows apexes, penumbra_rows base_radii,
                                  penumbra_rows apex_radii, uint32_t caps, penumbra_geometry* out) {
  return add_geometry(__func__, occluders, out, [&](Occluders& to) {
    if (caps > 1) refuse_argument("caps is neither 0 nor 1");
    return to.add_cones(rows_of<Vec3f>(bases, "bases"), rows_of<Vec3f>(apexes, "apexes"),
                        rows_of<float>(base_radii, "base_radii"),
                        rows_of<float>(apex_radii, "apex_radii"),
                        caps == 1 ? Caps::capped : Caps::open);
  });
}

penumbra_error penumbra_add_disks(penumbra_occluders occluders, penumbra_rows centers,
                                  penumbra_rows normals, penumbra_rows radii,
                                  penumbra_rows inner_radii, penumbra_geometry* out) {
  return add_geometry(__func__, occluders, out, [&](Occluders& to) {
    return to.add_disks(rows_of<Vec3f>(centers, "centers"), rows_of<Vec3f>(normals, "normals"),
                        rows_of<float>(radii, "radii"), rows_of<float>(inner_radii, "inner_radii"));
  });
}

penumbra_error penumbra_add_group(penumbra_occluders occluders, penumbra_occluders shapes,
                                  penumbra_group* out) {
  return change(__func__, occluders, [&](ApiObject& object) {
    const std::shared_ptr<ApiObject> source = object_of(shapes);
    if (object.group_sources.size() == object.group_sources.capacity())
      object.group_sources.reserve(2 * object.group_sources.size() + 1);
    add_part(object, object.groups, out, [&](Occluders& to) {
      const GroupId group = to.add_group(source->occluders);
      object.group_sources.push_back(source->serial);
      return group;
    });
  });
}

penumbra_error penumbra_add_instance(penumbra_occluders occluders, penumbra_group group,
                                     const double* placement, penumbra_instance* out) {
  return change(__func__, occluders, [&](ApiObject& object) {
    const GroupId placed{object.groups.number_of(group.id)};
    add_part(object, object.instances, out,
             [&](Occluders& to) { return to.add_instance(placed, transform_of(placement)); });
  });
}

penumbra_error penumbra_move_geometry(penumbra_occluders occluders, penumbra_geometry geometry,
                                      penumbra_rows positions) {
  return change(__func__, occluders, [&](ApiObject& object) {
    object.occluders.update(GeometryId{object.geometries.number_of(geometry.id)},
                            rows_of<Vec3f>(positions, "positions"));
  });
}

penumbra_error penumbra_move_instance(penumbra_occluders occluders, penumbra_instance instance,
                                      const double* placement) {
  return change(__func__, occluders, [&](ApiObject& object) {
    object.occluders.update(InstanceId{object.instances.number_of(instance.id)},
                            transform_of(placement));
  });
}

penumbra_error penumbra_move_group(penumbra_occluders occluders, penumbra_group group,
                                   penumbra_geometry geometry, penumbra_rows positions) {
  return change(__func__, occluders, [&](ApiObject& object) {
    const std::uint32_t number = object.groups.number_of(group.id);
    const std::uint64_t source = object.group_sources[number];
    object.occluders.update(GroupId{number}, GeometryId{geometry_number(geometry, source)},
                            rows_of<Vec3f>(positions, "positions"));
  });
}

penumbra_error penumbra_remove_geometry(penumbra_occluders occluders, penumbra_geometry geometry) {
  return change(__func__, occluders, [&](ApiObject& object) {
    const std::uint32_t number = object.geometries.number_of(geometry.id);
    object.occluders.remove(GeometryId{number});
    object.geometries.remove(number);
  });
}

penumbra_error penumbra_remove_instance(penumbra_occluders occluders, penumbra_instance instance) {
  return change(__func__, occluders, [&](ApiObject& object) {
    const std::uint32_t number = object.instances.number_of(instance.id);
    object.occluders.remove(InstanceId{number});
    object.instances.remove(number);
  });
}

penumbra_error penumbra_remove_group(penumbra_occluders occluders, penumbra_group group) {
  return change(__func__, occluders, [&](ApiObject& object) {
    const std::uint32_t number = object.groups.number_of(group.id);
    object.occluders.remove(GroupId{number});
    object.groups.remove(number);
  });
}

penumbra_error penumbra_default_commit_options(penumbra_commit_options* options,
                                               size_t struct_size) {
  return guarded(__func__, {}, [&] {
    check_pointer(options, "options");
    check_struct_size(struct_size, sizeof *options, "options");
    write_struct(options, {.struct_size = 0, .may_refit = CommitOptions{}.may_refit});
  });
}

penumbra_error penumbra_commit(penumbra_occluders occluders, const penumbra_commit_options* options,
                               penumbra_commit_report* report) {
  return guarded(__func__, occluders, [&] {
    const std::shared_ptr<ApiObject> object = object_of(occluders);
    const CommitOptions read = commit_options_of(options);
    if (report) read_struct(report, "report");
    const CommitReport made = object->occluders.commit(read);
    object->is_committed = true;
    if (report)
      write_struct(report, {.struct_size = 0,
                            .primitives = made.primitives,
                            .degenerate_triangles = made.degenerate_triangles,
                            .is_refitted = made.is_refitted});
  });
}

}  // extern "C"

}  // namespace penumbra
