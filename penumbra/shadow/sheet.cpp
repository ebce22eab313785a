// SPDX-License-Identifier: MIT
#include "penumbra/shadow/sheet.h"

#include <utility>

#include "penumbra/geometry/triangle_neighbors.h"

namespace penumbra {
namespace {

/// Whether a triangle has an edge from a to b. One that lies across such an edge of another, and
/// turns the same way, has it from b to a.
bool has_edge(const Record& triangle, Vec3f a, Vec3f b) {
  for (int k = 0; k < 3; ++k)
    if (triangle.vector(3 * k) == a && triangle.vector(3 * ((k + 1) % 3)) == b) return true;
  return false;
}

}  // namespace

TriangleSheet::TriangleSheet(const ShapeSet& shapes, const RecordTable& records)
    : own_(neighbors(shapes, records.own())), is_empty_(own_.empty()) {
  for (std::size_t i = 0; i < shapes.groups.size(); ++i) {
    of_group_.push_back(neighbors(shapes.groups[i], records.tree()->groups[i].records));
    is_empty_ &= of_group_.back().empty();
  }
}

TriangleSheet::Neighbors TriangleSheet::neighbors(const ShapeSet& shapes,
                                                  std::span<const Record> records) {
  std::size_t first = shapes.spheres.size() + shapes.cones.size() + shapes.rings.size();
  if (first == records.size()) return {};
  std::vector<std::uint32_t> record_of(records.size());  // by id
  for (std::uint32_t i = 0; i < records.size(); ++i) record_of[records[i].id] = i;
  Neighbors beside(records.size(), {no_record, no_record, no_record});
  for (const Mesh& mesh : shapes.meshes) {
    const auto across = triangle_neighbors(mesh);
    for (std::size_t t = 0; t < across.size(); ++t)
      for (int k = 0; k < 3; ++k) {
        if (across[t][k] == no_triangle) continue;
        const std::uint32_t here = record_of[first + t], there = record_of[first + across[t][k]];
        if (!records[there].casts_shadow) continue;
        const Vec3f a = records[here].vector(3 * k), b = records[here].vector(3 * ((k + 1) % 3));
        beside[here][k] = there | (has_edge(records[there], a, b) ? turned : 0);
      }
    first += across.size();
  }
  return beside;
}

bool TriangleSheet::fit(const Neighbors& neighbors, std::span<const Record> records) {
  if (neighbors.empty()) return true;  // no triangles
  for (std::size_t here = 0; here < records.size(); ++here)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t bits = neighbors[here][k];
      if (bits == no_record) continue;
      const Record& there = records[bits & ~turned];
      Vec3f a = records[here].vector(3 * k), b = records[here].vector(3 * ((k + 1) % 3));
      if (!(bits & turned)) std::swap(a, b);
      if (!has_edge(there, a, b)) return false;
    }
  return true;
}

bool TriangleSheet::fits(const RecordTable& records) const {
  if (!fit(own_, records.own())) return false;
  for (std::size_t i = 0; i < of_group_.size(); ++i)
    if (!fit(of_group_[i], records.tree()->groups[i].records)) return false;
  return true;
}

std::size_t TriangleSheet::memory_bytes() const {
  std::size_t sum = own_.capacity() * sizeof own_[0];
  for (const Neighbors& neighbors : of_group_) sum += neighbors.capacity() * sizeof neighbors[0];
  return sum;
}

void SheetScratch::clear() {
  found_.clear();
  if (++stamp_ == 0) slots_.fill({}), stamp_ = 1;  // slots of 2^32 searches ago
}

SheetScratch::Insert SheetScratch::insert(TriangleSheet::Member member) {
  std::uint32_t at = member.record * 0x9e3779b1u >> 16;
  for (;; ++at) {
    Slot& slot = slots_[at % slots_.size()];
    if (slot.stamp != stamp_) {
      slot = {member, stamp_};
      found_.push_back(member);
      return Insert::added;
    }
    if (slot.member.record == member.record)
      return slot.member.is_turned == member.is_turned ? Insert::known : Insert::contradicts;
  }
}

}  // namespace penumbra
