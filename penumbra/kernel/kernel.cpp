// SPDX-License-Identifier: MIT
#include "penumbra/kernel/kernel.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <memory>
#include <utility>

namespace penumbra {

struct Kernel::Data {
  KernelKind kind;
  WideTree tree;  // brute: records and placements alone
  // Ids of the first primitives of: spheres, cones, rings, then each mesh. Of the set's own shapes,
  // and of each group.
  std::vector<std::uint32_t> begin;
  std::vector<std::vector<std::uint32_t>> begin_in_group;
  Box box;
  NearestRecord nearest_to(const Ray& ray) const;
  ShapeRef shape_of(std::uint32_t id) const;
};

namespace {

std::vector<Record> all_records(const ShapeSet& shapes, const std::vector<bool>& casts_no_shadow) {
  const std::vector<ShapeRef> refs = all_primitives(shapes);
  std::vector<Record> records;
  records.reserve(refs.size());
  for (std::uint32_t id = 0; id < refs.size(); ++id) {
    Record record = make_record(shapes, refs[id], id);
    const std::uint32_t surface = surface_of(shapes, refs[id]);
    record.casts_shadow = surface >= casts_no_shadow.size() || !casts_no_shadow[surface];
    records.push_back(record);
  }
  return records;
}

std::vector<std::uint32_t> first_ids(const ShapeSet& shapes) {
  std::vector<std::uint32_t> begin{0};
  const auto add = [&](std::size_t count) {
    begin.push_back(begin.back() + static_cast<std::uint32_t>(count));
  };
  add(shapes.spheres.size());
  add(shapes.cones.size());
  add(shapes.rings.size());
  for (const Mesh& mesh : shapes.meshes) add(mesh.triangles.size());
  return begin;
}

/// Undoes `all_primitives`: the reference of one id.
ShapeRef find_shape(const std::vector<std::uint32_t>& begin, std::uint32_t id) {
  const auto range = std::upper_bound(begin.begin(), begin.end(), id) - begin.begin() - 1;
  const std::uint32_t offset = id - begin[range];
  if (range >= 3) return {ShapeKind::triangle, static_cast<std::uint32_t>(range - 3), offset, 0};
  return {static_cast<ShapeKind>(range), offset, 0, 0};
}

std::vector<Placement> placements_of(const ShapeSet& shapes, std::uint32_t first,
                                     const std::vector<WideTree>& groups) {
  std::vector<Placement> placements;
  placements.reserve(shapes.instances.size());
  for (const Instance& instance : shapes.instances) {
    const WideTree& group = groups[instance.group];
    placements.push_back(
        make_placement(instance.placement, group.nodes.front(), instance.group, first));
    first += static_cast<std::uint32_t>(group.records.size());
  }
  return placements;
}

/// Makes the tree's records anew of shapes that have moved.
void refit_records(WideTree& tree, const std::vector<std::uint32_t>& begin,
                   const ShapeSet& shapes) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, tree.records.size(), 4096),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t i = range.begin(); i < range.end(); ++i) {
                        Record& record = tree.records[i];
                        const bool casts_shadow = record.casts_shadow;
                        record = make_record(shapes, find_shape(begin, record.id), record.id);
                        record.casts_shadow = casts_shadow;
                      }
                    });
}

}  // namespace

Kernel::Kernel(std::unique_ptr<const Data> data) : data_(std::move(data)) {}

Kernel Kernel::refitted(const ShapeSet& shapes) const {
  auto data = std::make_unique<Data>(*data_);
  WideTree& tree = data->tree;
  for (std::size_t i = 0; i < tree.groups.size(); ++i) {
    refit_records(tree.groups[i], data->begin_in_group[i], shapes.groups[i]);
    refit_boxes(tree.groups[i]);
  }
  refit_records(tree, data->begin, shapes);
  tree.placements =
      placements_of(shapes, static_cast<std::uint32_t>(tree.records.size()), tree.groups);
  refit_boxes(tree);
  data->box = penumbra::bounds(shapes);
  return Kernel(std::move(data));
}

Kernel::Kernel(const ShapeSet& shapes, const KernelOptions& options) {
  auto data = std::make_unique<Data>();
  data->kind = options.kind;
  data->begin = first_ids(shapes);
  data->box = penumbra::bounds(shapes);
  std::vector<WideTree> groups;
  for (const ShapeSet& group : shapes.groups) {
    data->begin_in_group.push_back(first_ids(group));
    groups.push_back(build_wide_tree(all_records(group, options.casts_no_shadow)));
  }
  std::vector<Record> records = all_records(shapes, options.casts_no_shadow);
  std::vector<Placement> placements =
      placements_of(shapes, static_cast<std::uint32_t>(records.size()), groups);
  switch (options.kind) {
    case KernelKind::wide:
      data->tree = build_wide_tree(records, std::move(groups), std::move(placements));
      break;
    case KernelKind::brute:
      data->tree = {{}, std::move(records), std::move(groups), std::move(placements)};
      break;
  }
  data_ = std::move(data);
}

Kernel::~Kernel() = default;
Kernel::Kernel(Kernel&&) noexcept = default;
Kernel& Kernel::operator=(Kernel&&) noexcept = default;

NearestRecord Kernel::Data::nearest_to(const Ray& ray) const {
  return kind == KernelKind::wide ? nearest(tree, ray) : nearest_brute(tree, ray);
}

ShapeRef Kernel::Data::shape_of(std::uint32_t id) const {
  const RecordTable records(tree);
  if (id < records.own().size()) return find_shape(begin, id);
  const Placement* placement = records.run_of(id).placement;  // ids count as indices do
  ShapeRef ref = find_shape(begin_in_group[placement->group], id - placement->first);
  ref.instance = 1 + static_cast<std::uint32_t>(placement - tree.placements.data());
  return ref;
}

std::uint32_t Kernel::closest_record(const Ray& ray) const { return data_->nearest_to(ray).record; }

Kernel::ClosestResult Kernel::closest(const Ray& ray) const {
  const NearestRecord found = data_->nearest_to(ray);
  ClosestResult result{{}, found.tests};
  if (found.record != no_record) result.hit = Hit{found.t, data_->shape_of(found.id)};
  return result;
}

OccludedReport Kernel::occluded(const LightSamples& rays, std::span<const std::uint32_t> active,
                                std::span<std::uint32_t> blocked) const {
  return data_->kind == KernelKind::wide ? penumbra::occluded(data_->tree, rays, active, blocked)
                                         : occluded_brute(data_->tree, rays, active, blocked);
}

SingleReport Kernel::occluded_singly(const LightSamples& rays,
                                     std::span<const std::uint32_t> active, RecentRecords& recent,
                                     std::span<std::uint32_t> blocked) const {
  if (data_->kind == KernelKind::wide)
    return penumbra::occluded_singly(data_->tree, rays, active, recent, blocked);
  SingleReport report;
  report.tests = occluded_brute(data_->tree, rays, active, blocked).tests;
  for (const std::uint32_t word : active)
    report.traced += static_cast<std::uint64_t>(std::popcount(word));
  return report;
}

ShapeRef Kernel::shape(std::uint32_t record) const { return data_->shape_of(records()[record].id); }

const WideTree& Kernel::tree() const { return data_->tree; }

RecordTable Kernel::records() const { return data_->tree; }

std::size_t Kernel::memory_bytes() const { return data_->tree.memory_bytes(); }

Box Kernel::bounds() const { return data_->box; }

}  // namespace penumbra
