// SPDX-License-Identifier: MIT
// Occluders, and the arrays that they read: kept for as long as any commit may read them.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <atomic>
#include <cstdint>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include "penumbra/visibility/occluders.h"

namespace penumbra::python {

namespace py = pybind11;

/// What was added to which occluders.
template <class Id>
struct Handle {
  Id id;
  std::uint64_t owner = 0;   ///< `KeptOccluders::number`
  std::uint64_t source = 0;  ///< of a group: that of the occluders it was made of
};
using GeometryHandle = Handle<GeometryId>;
using GroupHandle = Handle<GroupId>;
using InstanceHandle = Handle<InstanceId>;

/// What a geometry reads, its positions first.
using Arrays = std::vector<py::object>;
/// By its number.
using Geometries = std::map<std::uint32_t, Arrays>;

/// All members are called with the interpreter's lock held, and let go of it while the library
/// works.
class KeptOccluders {
 public:
  KeptOccluders() = default;
  /// Of arrays that are the library's own.
  explicit KeptOccluders(Occluders occluders) : occluders_(std::move(occluders)) {}

  const std::uint64_t number = next_number++;
  const Occluders& asked() const { return occluders_; }

  /// `add(occluders)` gives the geometry that reads `arrays`.
  template <class Add>
  GeometryHandle add(Arrays arrays, Add add) {
    GeometryId id;
    change([&] { id = add(occluders_); }, [&] { geometries_[id.index].swap(arrays); });
    return {id, number, 0};
  }
  GroupHandle add_group(KeptOccluders& shapes);
  InstanceHandle add_instance(const GroupHandle& group, const Transform& placement);

  /// `positions` lie in `array`.
  void update(const GeometryHandle& geometry, VectorRows positions, py::object array);
  void update(const GroupHandle& group, const GeometryHandle& geometry, VectorRows positions,
              py::object array);
  void update(const InstanceHandle& instance, const Transform& placement);
  void remove(const GeometryHandle& geometry);
  void remove(const InstanceHandle& instance);
  void remove(const GroupHandle& group);

  CommitReport commit(const CommitOptions& options);

 private:
  /// Does `library` without the interpreter's lock and, if nothing was thrown, `keep` with it, as
  /// one change that no other comes between. No thread waits for `changes_` with the lock held.
  template <class Library, class Keep>
  void change(Library library, Keep keep) {
    const py::gil_scoped_release unlocked;
    const std::lock_guard lock(changes_);
    library();
    const py::gil_scoped_acquire locked;
    keep();
  }
  /// For arrays that are no longer wanted, but that a commit which began earlier may still read.
  void retire(const Arrays& arrays);
  template <class Id>
  void check(const Handle<Id>& handle) const;

  static inline std::atomic<std::uint64_t> next_number = 1;

  Occluders occluders_;
  std::mutex changes_;
  Geometries geometries_;
  std::map<std::uint32_t, Geometries> groups_;
  std::size_t commits_ = 0;  // that run now
  Arrays retired_;           // until there are none
};

}  // namespace penumbra::python
