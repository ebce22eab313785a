// SPDX-License-Identifier: MIT
// Umbra behind meshes, without volumes: a sheet of triangles that hides the whole light.
//
// Triangles side by side, each surely between p and all of the light, each turned the same way as
// its neighbour as seen from p, whose outline the shaft doesn't reach, block every sample. For the
// rays from p, the sheet is a map onto directions without folds; a path of directions from one it
// covers to any of the shaft's can leave it only through its outline, beyond which the shaft does
// not lie. This is the silhouette argument (S. Laine et al., Soft Shadow Volumes for Ray Tracing,
// SIGGRAPH 2005: visibility changes only at silhouette edges) made local, so that nothing is asked
// of the rest of the mesh: it may be open, dirty, or cross itself. (A record that is reached with
// both turns, on a one-sided surface, hides a fold, and proves nothing.)
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "penumbra/geometry/shape.h"
#include "penumbra/kernel/record_table.h"
#include "penumbra/kernel/traverse.h"
#include "penumbra/shadow/seen_light.h"

namespace penumbra {

/// Which records lie side by side.
class TriangleSheet {
 public:
  TriangleSheet() = default;
  /// `records`: the kernel's, of these shapes. Groups are stored once. Cost: O(n log n).
  TriangleSheet(const ShapeSet& shapes, const RecordTable& records);

  /// Whether it still holds for records that have moved (as many, in the same order): neighbours
  /// share their edge as they did. False: a new one is needed. Cost: linear.
  bool fits(const RecordTable& records) const;

  /// A record in the sheet, and whether its corners turn the other way than those of the record
  /// that the search began with.
  struct Member {
    std::uint32_t record = no_record;
    bool is_turned = false;
  };

  /// Of records: the neighbours of each, by the numbers that they have among them, and whether they
  /// turn otherwise.
  using Neighbors = std::vector<std::array<std::uint32_t, 3>>;

  /// What a search stays in: sheets don't go from an instance to what is outside of it.
  struct Part {
    const Neighbors* neighbors = nullptr;  ///< none where there are no triangles
    std::uint32_t first = 0;               ///< index of the first record

    /// Across the edge from corner k to corner (k + 1) % 3. No record at outlines, at edges of
    /// three triangles and more, and beside what casts no shadow.
    Member across(Member from, int edge) const {
      const std::uint32_t bits = (*neighbors)[from.record - first][edge];
      if (bits == no_record) return {};
      return {first + (bits & ~turned), from.is_turned != ((bits & turned) != 0)};
    }
  };
  Part part_of(const RecordRun& run) const {
    const Neighbors& neighbors = run.placement ? of_group_[run.placement->group] : own_;
    return {neighbors.empty() ? nullptr : &neighbors, run.first};
  }

  /// No triangles anywhere.
  bool is_empty() const { return is_empty_; }
  std::size_t memory_bytes() const;

 private:
  static constexpr std::uint32_t turned = 0x80000000u;
  static bool fit(const Neighbors& neighbors, std::span<const Record> records);
  static Neighbors neighbors(const ShapeSet& shapes, std::span<const Record> records);
  Neighbors own_;
  std::vector<Neighbors> of_group_;
  bool is_empty_ = true;
};

/// The triangles of a search: memory that is reused.
class SheetScratch {
 public:
  static constexpr std::uint32_t most = 4096;  ///< a power of 2
  void clear();
  /// Whether the record is new, or was there, turned the same way or the other.
  enum class Insert { added, known, contradicts };
  Insert insert(TriangleSheet::Member member);
  std::span<const TriangleSheet::Member> found() const { return found_; }

 private:
  struct Slot {
    TriangleSheet::Member member;
    std::uint32_t stamp = 0;
  };
  std::array<Slot, 2 * most> slots_{};
  std::uint32_t stamp_ = 0xffffff00u;  // begins near where it wraps, so that all tests see that
  std::vector<TriangleSheet::Member> found_;
};

/// True only if the sheet around the triangle `start`, grown until the shaft reaches no outline of
/// it, blocks every sample as seen from any of the receivers: proven, with the errors of float, the
/// samples and the intersector. False as well where that takes more than `most_triangles` (at most
/// SheetScratch::most), and for start records of other kinds. `light` must be certain. Adds the
/// triangles looked at to `tests`. Cost: 20 ns a triangle.
bool sheet_covers(const TriangleSheet& sheet, const RecordTable& records, const SeenLight& light,
                  std::uint32_t start, std::uint32_t most_triangles, SheetScratch& scratch,
                  std::uint64_t& tests);

}  // namespace penumbra
