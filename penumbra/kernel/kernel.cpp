// SPDX-License-Identifier: MIT
#include "penumbra/kernel/kernel.h"

#include <algorithm>
#include <bit>

namespace penumbra {

struct Kernel::Data {
  KernelKind kind;
  WideTree tree;  // brute: records alone
  std::vector<std::uint32_t>
      begin;  // id of the first primitive of: spheres, cones, rings, then each mesh
  Box box;
  NearestRecord nearest_to(const Ray& ray) const;
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
ShapeRef shape_of(const std::vector<std::uint32_t>& begin, std::uint32_t id) {
  const auto range = std::upper_bound(begin.begin(), begin.end(), id) - begin.begin() - 1;
  const std::uint32_t offset = id - begin[range];
  if (range >= 3) return {ShapeKind::triangle, static_cast<std::uint32_t>(range - 3), offset, 0};
  return {static_cast<ShapeKind>(range), offset, 0, 0};
}

}  // namespace

Kernel::Kernel(const ShapeSet& shapes, const KernelOptions& options) {
  auto data = std::make_unique<Data>();
  data->kind = options.kind;
  data->begin = first_ids(shapes);
  data->box = penumbra::bounds(shapes);
  std::vector<Record> records = all_records(shapes, options.casts_no_shadow);
  switch (options.kind) {
    case KernelKind::wide: data->tree = build_wide_tree(records); break;
    case KernelKind::brute: data->tree.records = std::move(records); break;
  }
  data_ = std::move(data);
}

Kernel::~Kernel() = default;
Kernel::Kernel(Kernel&&) noexcept = default;
Kernel& Kernel::operator=(Kernel&&) noexcept = default;

NearestRecord Kernel::Data::nearest_to(const Ray& ray) const {
  return kind == KernelKind::wide ? nearest(tree, ray) : nearest_brute(tree.records, ray);
}

std::uint32_t Kernel::closest_record(const Ray& ray) const {
  const NearestRecord found = data_->nearest_to(ray);
  return found.record ? static_cast<std::uint32_t>(found.record - records().data()) : no_record;
}

Kernel::ClosestResult Kernel::closest(const Ray& ray) const {
  const NearestRecord found = data_->nearest_to(ray);
  ClosestResult result{{}, found.tests};
  if (found.record) result.hit = Hit{found.t, shape_of(data_->begin, found.record->id)};
  return result;
}

OccludedReport Kernel::occluded(const LightSamples& rays, std::span<const std::uint32_t> active,
                                std::span<std::uint32_t> blocked) const {
  return data_->kind == KernelKind::wide
             ? penumbra::occluded(data_->tree, rays, active, blocked)
             : occluded_brute(data_->tree.records, rays, active, blocked);
}

SingleReport Kernel::occluded_singly(const LightSamples& rays,
                                     std::span<const std::uint32_t> active, RecentRecords& recent,
                                     std::span<std::uint32_t> blocked) const {
  if (data_->kind == KernelKind::wide)
    return penumbra::occluded_singly(data_->tree, rays, active, recent, blocked);
  SingleReport report;
  report.tests = occluded_brute(data_->tree.records, rays, active, blocked).tests;
  for (const std::uint32_t word : active)
    report.traced += static_cast<std::uint64_t>(std::popcount(word));
  return report;
}

std::span<const Record> Kernel::records() const { return data_->tree.records; }

std::span<const WideNode> Kernel::nodes() const { return data_->tree.nodes; }

std::size_t Kernel::memory_bytes() const { return data_->tree.memory_bytes(); }

Box Kernel::bounds() const { return data_->box; }

}  // namespace penumbra
