// SPDX-License-Identifier: MIT
// Random calls of the C API on handles that are live, dead, of another kind, or made up.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "penumbra/penumbra_c.h"
#include "tests/visibility/api_arguments.h"

namespace penumbra::fuzz {

/// A handle and that of its occluders. Where two threads write one at once, the two may not belong
/// together: one misuse more.
struct PartSlot {
  std::atomic<std::uint64_t> owner = 0, id = 0;
};

/// The handles that all threads use.
struct Pool {
  std::array<std::atomic<std::uint64_t>, 4> occluders{};
  std::array<PartSlot, 16> geometries;
  std::array<PartSlot, 6> groups;
  std::array<PartSlot, 8> instances;
  std::atomic<std::uint64_t> told_errors = 0;

  Pool() = default;
  ~Pool();
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;
};

struct Tally {
  std::uint64_t calls = 0, fine = 0, commits = 0, refits = 0, out_of_memory = 0, compared = 0;

  void add(const Tally& other);
};

class Caller {
 public:
  /// `is_alone`: no other thread calls. Then arrays move, memory runs out, and answers are
  /// compared.
  Caller(Pool& pool, Arrays& arrays, std::uint64_t seed, bool is_alone);

  /// One random call. False where it came to something that is not defined; that is printed.
  bool call();
  const Tally& tally() const { return tally_; }

 private:
  using Rows = penumbra_rows;

  /// What was just committed gives the same answers by both methods, also when it is built anew.
  bool compare();

  penumbra_error random_call();
  penumbra_error create();
  penumbra_error release();
  penumbra_error add_geometry();
  penumbra_error add_group();
  penumbra_error add_instance();
  penumbra_error update();
  penumbra_error move_arrays();
  penumbra_error remove();
  penumbra_error commit();
  penumbra_error ask();
  penumbra_error ask_for_blockers();
  penumbra_error ask_for_facts();
  penumbra_error set_error_function();

  /// A slot, and its handle or, rarely, garbage.
  penumbra_occluders some_occluders();
  template <class Slots>
  PartSlot& some_slot(Slots& slots);
  std::uint64_t some_id(const PartSlot& slot);
  /// Those of the slot, but rarely.
  penumbra_occluders owner_of(const PartSlot& slot);
  template <class Slots>
  void keep(Slots& slots, penumbra_occluders owner, std::uint64_t id);
  std::uint64_t garbage();

  Pool& pool_;
  Arrays& arrays_;
  Random random_;
  bool is_alone_;
  Tally tally_;
  penumbra_occluders committed_{};  // by the last call; {0}: it was no commit
};

}  // namespace penumbra::fuzz
