// SPDX-License-Identifier: MIT
#include "kept_occluders.h"

namespace penumbra::python {

template <class Id>
void KeptOccluders::check(const Handle<Id>& handle) const {
  if (handle.owner != number)
    throw py::value_error("that was added to other occluders; name what this object gave");
}

void KeptOccluders::retire(const Arrays& arrays) {
  if (commits_ > 0) retired_.insert(retired_.end(), arrays.begin(), arrays.end());
}

GroupHandle KeptOccluders::add_group(KeptOccluders& shapes) {
  GroupId id;
  const auto keep = [&] { groups_[id.index] = shapes.geometries_; };
  if (&shapes == this) {
    change([&] { id = occluders_.add_group(occluders_); }, keep);
    return {id, number, number};
  }
  const py::gil_scoped_release unlocked;
  const std::scoped_lock lock(changes_, shapes.changes_);
  id = occluders_.add_group(shapes.occluders_);
  const py::gil_scoped_acquire locked;
  keep();
  return {id, number, shapes.number};
}

InstanceHandle KeptOccluders::add_instance(const GroupHandle& group, const Transform& placement) {
  check(group);
  InstanceId id;
  change([&] { id = occluders_.add_instance(group.id, placement); }, [] {});
  return {id, number, 0};
}

// In these, `old` outlives the lock: what it holds may have a finaliser that comes back here.

void KeptOccluders::update(const GeometryHandle& geometry, VectorRows positions, py::object array) {
  check(geometry);
  Arrays old;
  change([&] { occluders_.update(geometry.id, positions); },
         [&] {
           old = {std::exchange(geometries_.at(geometry.id.index).front(), std::move(array))};
           retire(old);
         });
}

void KeptOccluders::update(const GroupHandle& group, const GeometryHandle& geometry,
                           VectorRows positions, py::object array) {
  check(group);
  if (geometry.owner != group.source)
    throw py::value_error("that geometry is none of the occluders that the group was made of");
  Arrays old;
  change([&] { occluders_.update(group.id, geometry.id, positions); },
         [&] {
           Arrays& arrays = groups_.at(group.id.index).at(geometry.id.index);
           old = {std::exchange(arrays.front(), std::move(array))};
           retire(old);
         });
}

void KeptOccluders::update(const InstanceHandle& instance, const Transform& placement) {
  check(instance);
  change([&] { occluders_.update(instance.id, placement); }, [] {});
}

void KeptOccluders::remove(const GeometryHandle& geometry) {
  check(geometry);
  Arrays old;
  change([&] { occluders_.remove(geometry.id); },
         [&] {
           auto gone = geometries_.extract(geometry.id.index);
           retire(old = std::move(gone.mapped()));
         });
}

void KeptOccluders::remove(const InstanceHandle& instance) {
  check(instance);
  change([&] { occluders_.remove(instance.id); }, [] {});
}

void KeptOccluders::remove(const GroupHandle& group) {
  check(group);
  Arrays old;
  change([&] { occluders_.remove(group.id); },
         [&] {
           auto gone = groups_.extract(group.id.index);
           for (auto& [index, arrays] : gone.mapped())
             old.insert(old.end(), arrays.begin(), arrays.end());
           retire(old);
         });
}

CommitReport KeptOccluders::commit(const CommitOptions& options) {
  /// Counts with the lock held, also when the commit throws.
  struct Running {
    explicit Running(KeptOccluders& of) : kept(of) { ++kept.commits_; }
    ~Running() {
      if (--kept.commits_ == 0) std::exchange(kept.retired_, {});
    }
    KeptOccluders& kept;
  };
  const Running running(*this);
  const py::gil_scoped_release unlocked;
  return occluders_.commit(options);
}

}  // namespace penumbra::python
