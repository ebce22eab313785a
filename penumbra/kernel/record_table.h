// SPDX-License-Identifier: MIT
// All records of a kernel by index: first those that it stores, then those of each placement, which
// are formed when they are asked for.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "penumbra/kernel/wide_tree.h"

namespace penumbra {

/// The records of one placement, or those that no instance places.
struct RecordRun {
  std::span<const Record> stored;
  const Placement* placement = nullptr;  ///< null: they are in the world as they are
  std::uint32_t first = 0;               ///< index of the first

  /// The reference is to the stored record, or to `room`.
  const Record& get(std::uint32_t index, Record& room) const {
    const Record& record = stored[index - first];
    return placement ? room = placed(record, *placement) : record;
  }
};

/// Refers to a tree, or to records alone, which must live as long.
class RecordTable {
 public:
  RecordTable(std::span<const Record> records) : own_(records) {}  // NOLINT: a table of these
  RecordTable(const Record* records, std::size_t count) : own_(records, count) {}
  RecordTable(const WideTree& tree)  // NOLINT: a tree's records
      : own_(tree.records), tree_(&tree) {}

  /// Index below `size()`. The reference is to a stored record or to `room`. Cost: that of a look
  /// up for placed ones, 20 ns.
  const Record& get(std::uint32_t index, Record& room) const {
    if (index < own_.size()) return own_[index];
    return run_of(index).get(index, room);
  }
  Record operator[](std::uint32_t index) const {
    Record room;
    return get(index, room);
  }

  /// The run that holds an index.
  RecordRun run_of(std::uint32_t index) const {
    if (index < own_.size()) return {own_, nullptr, 0};
    const auto after = std::upper_bound(
        tree_->placements.begin(), tree_->placements.end(), index,
        [](std::uint32_t i, const Placement& placement) { return i < placement.first; });
    const Placement& placement = after[-1];
    return {tree_->groups[placement.group].records, &placement, placement.first};
  }

  /// Those that no instance places: indices 0 and on.
  std::span<const Record> own() const { return own_; }

  /// The tree that holds them; null for a table of records alone.
  const WideTree* tree() const { return tree_; }

  std::span<const Placement> placements() const {
    return tree_ ? std::span<const Placement>(tree_->placements) : std::span<const Placement>();
  }

  std::size_t size() const {
    if (placements().empty()) return own_.size();
    const Placement& last = tree_->placements.back();
    return last.first + tree_->groups[last.group].records.size();
  }

 private:
  std::span<const Record> own_;
  const WideTree* tree_ = nullptr;
};

}  // namespace penumbra
