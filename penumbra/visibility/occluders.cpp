// SPDX-License-Identifier: MIT
#include "penumbra/visibility/occluders.h"

#include <mutex>
#include <utility>

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include "penumbra/geometry/light_sampling.h"
#include "penumbra/scene/coordinates.h"
#include "penumbra/scene/error.h"
#include "penumbra/visibility/ask.h"
#include "penumbra/visibility/blockers.h"
#include "penumbra/visibility/committed.h"
#include "penumbra/visibility/description.h"
#include "penumbra/visibility/gather.h"
#include "penumbra/visibility/lights.h"

namespace penumbra {

struct Occluders::Data {
  /// Held while what was added changes, and all the while a commit reads it.
  std::mutex description_mutex;
  Description description;
  std::vector<std::shared_ptr<const void>> owners;

  /// Held for the moment in which it is read or replaced.
  std::mutex committed_mutex;
  std::shared_ptr<const Committed> committed;

  std::shared_ptr<const Committed> current() {
    const std::lock_guard lock(committed_mutex);
    return committed;
  }
};

namespace {

[[noreturn]] void fail(std::string what, std::string hint) {
  throw Error({}, std::move(what), std::move(hint));
}

void require_rows(const char* what, std::size_t count, std::size_t wanted, const char* of) {
  if (count != wanted)
    fail(fmt::format("{} {} for {} {}", count, what, wanted, of), "give one each");
}

template <class T>
std::uint32_t add_to(Numbered<T>& numbered, T item, const char* what) {
  if (numbered.size() >= PrimitiveId::no_instance)
    fail(fmt::format("too many {}", what), "use fewer");
  numbered.emplace_back(std::move(item));
  return static_cast<std::uint32_t>(numbered.size() - 1);
}

/// What was added by that number.
template <class T>
std::optional<T>& at(Numbered<T>& numbered, std::uint32_t index, const char* what) {
  if (index >= numbered.size())
    fail(fmt::format("there is no {} {}", what, index), "name what was added");
  if (!numbered[index])
    fail(fmt::format("{} {} was removed", what, index), "name what is there still");
  return numbered[index];
}

void move_rows(GeometryRows& geometry, VectorRows positions) {
  require_rows("positions", positions.size(), geometry.positions.size(), "that were there before");
  geometry.positions = positions;
}

std::shared_ptr<const Committed> committed(const std::shared_ptr<const Committed>& current) {
  if (!current) fail("the occluders are asked before they were committed", "call commit first");
  return current;
}

/// An empty one says that nothing is wanted: of a question, it is wrong. Others are checked by
/// `ask`.
template <class T>
void require_room(std::span<T> out, const Points& points) {
  if (out.empty() && !points.positions.empty())
    fail(fmt::format("room for 0 answers of {} points", points.positions.size()), "give as much");
}

constexpr std::size_t most_rows = 0xfffffffeu;

void require_few(std::size_t rows) {
  if (rows > most_rows) fail("a geometry of more than 2^32 - 2 rows", "split it");
}

}  // namespace

Occluders::Data& Occluders::data() const {
  if (!data_) fail("the occluders were moved elsewhere", "use those that they were moved to");
  return *data_;
}

Occluders::Occluders() : data_(std::make_unique<Data>()) {}
Occluders::~Occluders() = default;
Occluders::Occluders(Occluders&&) noexcept = default;
Occluders& Occluders::operator=(Occluders&&) noexcept = default;

GeometryId Occluders::add(const GeometryRows& rows) {
  require_few(rows.positions.size());
  require_few(rows.triangles.size());
  const std::lock_guard lock(data().description_mutex);
  const GeometryId id{add_to(data().description.geometries, rows, "geometries")};
  return id;
}

GeometryId Occluders::add_triangles(VectorRows positions, TriangleRows triangles) {
  return add({.kind = ShapeKind::triangle, .positions = positions, .triangles = triangles});
}

GeometryId Occluders::add_spheres(VectorRows centers, NumberRows radii) {
  require_rows("radii", radii.size(), centers.size(), "spheres");
  return add({.kind = ShapeKind::sphere, .positions = centers, .radii = radii});
}

GeometryId Occluders::add_cones(VectorRows bases, VectorRows apexes, NumberRows base_radii,
                                NumberRows apex_radii, Caps caps) {
  require_rows("apexes", apexes.size(), bases.size(), "bases");
  require_rows("base radii", base_radii.size(), bases.size(), "bases");
  require_rows("apex radii", apex_radii.size(), bases.size(), "bases");
  return add({.kind = ShapeKind::cone,
              .positions = bases,
              .directions = apexes,
              .radii = base_radii,
              .other_radii = apex_radii,
              .caps = caps});
}

GeometryId Occluders::add_disks(VectorRows centers, VectorRows normals, NumberRows radii,
                                NumberRows inner_radii) {
  require_rows("normals", normals.size(), centers.size(), "disks");
  require_rows("radii", radii.size(), centers.size(), "disks");
  if (!inner_radii.empty())
    require_rows("inner radii", inner_radii.size(), centers.size(), "disks");
  return add({.kind = ShapeKind::ring,
              .positions = centers,
              .directions = normals,
              .radii = radii,
              .other_radii = inner_radii});
}

GroupId Occluders::add_group(const Occluders& shapes) {
  if (&shapes == this) fail("a group of itself", "give another object's shapes");
  Numbered<GeometryRows> geometries;
  std::vector<std::shared_ptr<const void>> owners;
  {
    const std::lock_guard lock(shapes.data().description_mutex);
    for (const auto& instance : shapes.data().description.instances)
      if (instance) fail("a group has instances", "compose the placements");
    geometries = shapes.data().description.geometries;
    owners = shapes.data().owners;
  }
  const std::lock_guard lock(data().description_mutex);
  const GroupId id{add_to(data().description.groups, std::move(geometries), "groups")};
  data().owners.insert(data().owners.end(), owners.begin(), owners.end());
  return id;
}

InstanceId Occluders::add_instance(GroupId group, const Transform& placement) {
  const std::lock_guard lock(data().description_mutex);
  at(data().description.groups, group.index, "group");
  const Instance instance{group.index, placement};
  const InstanceId id{add_to(data().description.instances, instance, "instances")};
  return id;
}

void Occluders::update(GeometryId geometry, VectorRows positions) {
  const std::lock_guard lock(data().description_mutex);
  move_rows(*at(data().description.geometries, geometry.index, "geometry"), positions);
}

void Occluders::update(GroupId group, GeometryId geometry, VectorRows positions) {
  const std::lock_guard lock(data().description_mutex);
  auto& geometries = *at(data().description.groups, group.index, "group");
  move_rows(*at(geometries, geometry.index, "geometry"), positions);
}

void Occluders::update(InstanceId instance, const Transform& placement) {
  const std::lock_guard lock(data().description_mutex);
  at(data().description.instances, instance.index, "instance")->placement = placement;
}

void Occluders::keep(std::shared_ptr<const void> owner) {
  const std::lock_guard lock(data().description_mutex);
  data().owners.push_back(std::move(owner));
}

void Occluders::remove(GeometryId geometry) {
  const std::lock_guard lock(data().description_mutex);
  at(data().description.geometries, geometry.index, "geometry").reset();
}

void Occluders::remove(InstanceId instance) {
  const std::lock_guard lock(data().description_mutex);
  at(data().description.instances, instance.index, "instance").reset();
}

void Occluders::remove(GroupId group) {
  const std::lock_guard lock(data().description_mutex);
  auto& removed = at(data().description.groups, group.index, "group");
  for (const auto& instance : data().description.instances)
    if (instance && instance->group == group.index)
      fail(fmt::format("group {} is placed by instances", group.index), "remove these first");
  removed.reset();
}

CommitReport Occluders::commit(const CommitOptions& options) {
  const std::lock_guard lock(data().description_mutex);
  GatheredShapes gathered = gather(data().description);
  CommitReport report{primitive_count(gathered.shapes), gathered.degenerate_triangles, false};
  const std::shared_ptr<const Committed> before = data().current();
  std::shared_ptr<const Committed> made;
  const bool may_refit = before && options.may_refit;
  // The caller's own tasks, which may commit as well, are not taken up by a thread that waits here
  // and holds what they would wait for.
  tbb::this_task_arena::isolate([&] {
    if (may_refit) made = refitted(*before, gathered);
    report.is_refitted = made != nullptr;
    if (!made) made = build(std::move(gathered));
  });
  const std::lock_guard swap_lock(data().committed_mutex);
  data().committed = std::move(made);
  return report;
}

ShadowCounters Occluders::visibility(const Points& points, const LightShape& light,
                                     std::span<Visibility> out, const AskOptions& options) const {
  require_room(out, points);
  return ask(*committed(data().current()), points, light, options, {.visibility = out});
}

ShadowCounters Occluders::classify(const Points& points, const LightShape& light,
                                   std::span<ShadowClass> out, const AskOptions& options) const {
  require_room(out, points);
  return ask(*committed(data().current()), points, light, options, {.shadow_class = out});
}

std::vector<ShadowClass> Occluders::classify(const Points& points, const LightShape& light,
                                             const AskOptions& options) const {
  std::vector<ShadowClass> out(points.positions.size());
  classify(points, light, out, options);
  return out;
}

ShadowCounters Occluders::visible_fraction(const Points& points, const LightShape& light,
                                           std::span<float> out, const AskOptions& options) const {
  require_room(out, points);
  return ask(*committed(data().current()), points, light, options, {.fraction = out});
}

std::vector<float> Occluders::visible_fraction(const Points& points, const LightShape& light,
                                               const AskOptions& options) const {
  std::vector<float> out(points.positions.size());
  visible_fraction(points, light, out, options);
  return out;
}

ShadowCounters Occluders::visible_samples(const Points& points, const LightShape& light,
                                          std::span<std::uint32_t> out,
                                          const AskOptions& options) const {
  require_room(out, points);
  return ask(*committed(data().current()), points, light, options, {.free_samples = out});
}

Blockers Occluders::blockers(Vec3f position, Vec3f normal, const LightShape& light) const {
  const auto occluders = committed(data().current());
  return blockers_of_point(*occluders, {position, receiver_normal(normal)},
                           checked_light(*occluders, light));
}

Blockers Occluders::shaft(const Box& box, const LightShape& light) const {
  const auto occluders = committed(data().current());
  if (box.is_empty() || !is_coordinate(box.lo) || !is_coordinate(box.hi))
    fail("the box of a shaft is empty, or reaches beyond 1e15", "give its lower corner first");
  return blockers_of_box(*occluders, box, checked_light(*occluders, light));
}

Box Occluders::bounds() const { return committed(data().current())->kernel.bounds(); }

std::size_t Occluders::memory_bytes() const { return committed(data().current())->memory_bytes(); }

std::vector<Vec3f> light_samples(const LightShape& light, Vec3f position, std::uint64_t key,
                                 std::uint32_t shadow_samples,
                                 std::optional<std::uint32_t> light_index) {
  require_samples(shadow_samples);
  const LightShape checked = checked_light(light);
  LightSamples samples;
  sample_light(checked, position, SamplePattern(shadow_samples),
               light_index ? light_key(key, *light_index) : key, samples);
  std::vector<Vec3f> ways;
  for (std::uint32_t i = 0; i < shadow_samples; ++i)
    ways.push_back({samples.x[i], samples.y[i], samples.z[i]});
  return ways;
}

}  // namespace penumbra
