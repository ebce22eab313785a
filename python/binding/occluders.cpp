// SPDX-License-Identifier: MIT
#include "occluders.h"

#include <string>

#include "arrays.h"

namespace penumbra::python {
namespace {

/// Rows of a 3x4 or 4x4 matrix that maps columns (x, y, z, 1).
Transform transform_of(py::handle object) {
  refuse_mask(object, "placement");
  constexpr const char* wanted = "placement must be a matrix of shape (3, 4) or (4, 4)";
  const auto matrix = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(
      py::reinterpret_borrow<py::object>(object));
  if (!matrix || matrix.ndim() != 2 || matrix.shape(1) != 4 ||
      (matrix.shape(0) != 3 && matrix.shape(0) != 4))
    throw py::value_error(wanted);
  const auto at = matrix.unchecked<2>();
  if (matrix.shape(0) == 4 && !(at(3, 0) == 0 && at(3, 1) == 0 && at(3, 2) == 0 && at(3, 3) == 1))
    throw py::value_error(std::string(wanted) + "; the last row of such is 0, 0, 0, 1");
  const auto column = [&at](int j) { return Vec3d(at(0, j), at(1, j), at(2, j)); };
  return {column(0), column(1), column(2), column(3)};
}

template <class Id>
void bind_handle(py::module_& m, const char* name, const char* help) {
  using H = Handle<Id>;
  py::class_<H>(m, name, help)
      .def_property_readonly("index", [](const H& h) { return h.id.index; })
      .def("__eq__",
           [](const H& a, py::object b) {
             return py::isinstance<H>(b) && a.owner == py::cast<const H&>(b).owner &&
                    a.id.index == py::cast<const H&>(b).id.index;
           })
      .def("__hash__", [](const H& h) { return py::hash(py::make_tuple(h.owner, h.id.index)); })
      .def("__repr__", [name](const H& h) {
        return "<" + std::string(name) + " " + std::to_string(h.id.index) + ">";
      });
}

GeometryHandle add_triangles(KeptOccluders& o, py::object positions, py::object triangles) {
  const auto p = vector_rows(positions, "positions");
  const auto t = triangle_rows(triangles, "triangles");
  return o.add({p.array, t.array}, [&](Occluders& to) { return to.add_triangles(p.rows, t.rows); });
}

GeometryHandle add_spheres(KeptOccluders& o, py::object centers, py::object radii) {
  const auto c = vector_rows(centers, "centers");
  const auto r = number_rows(radii, "radii", c.rows.size());
  return o.add({c.array, r.array}, [&](Occluders& to) { return to.add_spheres(c.rows, r.rows); });
}

GeometryHandle add_cones(KeptOccluders& o, py::object bases, py::object apexes,
                         py::object base_radii, py::object apex_radii, bool capped) {
  const auto b = vector_rows(bases, "bases"), a = vector_rows(apexes, "apexes");
  const auto br = number_rows(base_radii, "base_radii", b.rows.size());
  const auto ar = number_rows(apex_radii, "apex_radii", b.rows.size());
  return o.add({b.array, a.array, br.array, ar.array}, [&](Occluders& to) {
    return to.add_cones(b.rows, a.rows, br.rows, ar.rows, capped ? Caps::capped : Caps::open);
  });
}

GeometryHandle add_disks(KeptOccluders& o, py::object centers, py::object normals, py::object radii,
                         py::object inner_radii) {
  const auto c = vector_rows(centers, "centers"), n = vector_rows(normals, "normals");
  const auto r = number_rows(radii, "radii", c.rows.size());
  HeldRows<float> inner{py::array(), {}};
  if (!inner_radii.is_none()) inner = number_rows(inner_radii, "inner_radii", c.rows.size());
  return o.add({c.array, n.array, r.array, inner.array},
               [&](Occluders& to) { return to.add_disks(c.rows, n.rows, r.rows, inner.rows); });
}

void bind_changes(OccludersClass& c) {
  c.def("update_geometry",
        [](KeptOccluders& o, const GeometryHandle& geometry, py::object positions) {
          const auto p = vector_rows(positions, "positions");
          o.update(geometry, p.rows, p.array);
        })
      .def("update_instance",
           [](KeptOccluders& o, const InstanceHandle& instance, py::object placement) {
             o.update(instance, transform_of(placement));
           })
      .def("update_group",
           [](KeptOccluders& o, const GroupHandle& group, const GeometryHandle& geometry,
              py::object positions) {
             const auto p = vector_rows(positions, "positions");
             o.update(group, geometry, p.rows, p.array);
           })
      .def("remove", [](KeptOccluders& o, const GeometryHandle& h) { o.remove(h); })
      .def("remove", [](KeptOccluders& o, const InstanceHandle& h) { o.remove(h); })
      .def("remove", [](KeptOccluders& o, const GroupHandle& h) { o.remove(h); });
}

}  // namespace

void bind_occluders(py::module_& m) {
  bind_handle<GeometryId>(m, "Geometry", "What one call added to occluders.");
  bind_handle<GroupId>(m, "Group", "Shapes that instances place.");
  bind_handle<InstanceId>(m, "Instance", "A placement of a group.");
  py::class_<CommitReport>(m, "CommitReport", "What a commit found.")
      .def_readonly("primitives", &CommitReport::primitives)
      .def_readonly("degenerate_triangles", &CommitReport::degenerate_triangles)
      .def_readonly("is_refitted", &CommitReport::is_refitted)
      .def("__repr__", [](const CommitReport& r) {
        return py::str("CommitReport(primitives={}, degenerate_triangles={}, is_refitted={})")
            .format(r.primitives, r.degenerate_triangles, r.is_refitted);
      });

  OccludersClass c(m, "Occluders");
  c.def(py::init<>())
      .def("add_triangles", &add_triangles)
      .def("add_spheres", &add_spheres)
      .def("add_cones", &add_cones)
      .def("add_disks", &add_disks)
      .def("add_group", &KeptOccluders::add_group)
      .def("add_instance",
           [](KeptOccluders& o, const GroupHandle& group, py::object placement) {
             return o.add_instance(group, transform_of(placement));
           })
      .def("commit",
           [](KeptOccluders& o, bool may_refit) { return o.commit({.may_refit = may_refit}); })
      .def("bounds",
           [](const KeptOccluders& o) {
             const Box box = o.asked().bounds();
             return py::make_tuple(tuple_of(box.lo), tuple_of(box.hi));
           })
      .def("memory_bytes", [](const KeptOccluders& o) { return o.asked().memory_bytes(); });
  bind_changes(c);
  bind_questions(m, c);
}

}  // namespace penumbra::python
