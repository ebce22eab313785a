// SPDX-License-Identifier: MIT
#include "tests/visibility/api_calls.h"

#include <algorithm>
#include <cstdio>
#include <new>
#include <optional>
#include <vector>

#include "tests/visibility/api_answers.h"
#include "tests/visibility/failing_new.h"

namespace penumbra::fuzz {
namespace {

void count_error(void* user, penumbra_error code, const char* message) {
  auto& told = *static_cast<std::atomic<std::uint64_t>*>(user);
  if (code != PENUMBRA_OK && message[0] != '\0') ++told;
}

int go_on(void*, double) { return 1; }
int cancel(void*, double share) { return share > 0.5 ? 0 : 1; }
int call_again(void*, double) {
  penumbra_occluders made{};
  return penumbra_create(&made) == PENUMBRA_ERROR_INVALID_OPERATION ? 1 : 0;
}

bool is_defined(penumbra_error code) {
  return code >= PENUMBRA_OK && code < PENUMBRA_ERROR_INTERNAL;
}

}  // namespace

Pool::~Pool() {
  for (const auto& id : occluders) penumbra_release({id});
  penumbra_set_error_function({}, nullptr, nullptr);
}

void Tally::add(const Tally& other) {
  calls += other.calls, fine += other.fine, commits += other.commits, refits += other.refits;
  out_of_memory += other.out_of_memory, compared += other.compared;
}

Caller::Caller(Pool& pool, Arrays& arrays, std::uint64_t seed, bool is_alone)
    : pool_(pool), arrays_(arrays), random_(seed), is_alone_(is_alone) {}

std::uint64_t Caller::garbage() {
  const auto bits = std::uint64_t{random_.below(~0u)} << 32 | random_.below(~0u);
  if (random_.one_in(3)) return bits;
  if (random_.one_in(2)) return random_.below(4);
  // Nearly one that was given.
  const std::uint64_t given = pool_.geometries[random_.below(pool_.geometries.size())].id;
  return given ^ (std::uint64_t{1} << random_.below(64));
}

penumbra_occluders Caller::some_occluders() {
  if (random_.one_in(40)) return {garbage()};
  return {pool_.occluders[random_.below(pool_.occluders.size())]};
}

template <class Slots>
PartSlot& Caller::some_slot(Slots& slots) {
  return slots[random_.below(slots.size())];
}

std::uint64_t Caller::some_id(const PartSlot& slot) {
  if (random_.one_in(40)) return garbage();
  if (random_.one_in(40)) return some_slot(pool_.instances).id;
  return slot.id;
}

penumbra_occluders Caller::owner_of(const PartSlot& slot) {
  return random_.one_in(40) ? some_occluders() : penumbra_occluders{slot.owner};
}

template <class Slots>
void Caller::keep(Slots& slots, penumbra_occluders owner, std::uint64_t id) {
  PartSlot& slot = some_slot(slots);
  slot.owner = owner.id;
  slot.id = id;
}

bool Caller::call() {
  committed_ = {};
  std::optional<FailingNew> failing;
  const bool fails = is_alone_ && random_.one_in(20);
  if (fails) failing.emplace(random_.below(random_.one_in(2) ? 10 : 300));
  penumbra_error code = PENUMBRA_OK;
  try {
    code = random_call();
  } catch (const std::bad_alloc&) {
    if (!fails) throw;  // else of these lines themselves: nothing comes out of C
  }
  failing.reset();
  ++tally_.calls;
  tally_.fine += code == PENUMBRA_OK;
  tally_.out_of_memory += code == PENUMBRA_ERROR_OUT_OF_MEMORY;
  const bool is_told = code == PENUMBRA_OK || penumbra_last_error() == code;
  if (!is_defined(code) || !is_told || (code == PENUMBRA_ERROR_OUT_OF_MEMORY && !fails)) {
    std::fprintf(stderr, "code %d, last error: %s\n", static_cast<int>(code),
                 penumbra_last_error_message());
    return false;
  }
  return !is_alone_ || committed_.id == 0 || compare();
}

bool Caller::compare() {
  if (random_.one_in(2)) return true;
  const std::optional<std::uint64_t> compared = compare_answers(committed_, arrays_, random_);
  if (compared) tally_.compared += *compared;
  return compared.has_value();
}

penumbra_error Caller::random_call() {
  switch (random_.below(is_alone_ ? 32 : 28)) {
    case 0: return create();
    case 1: return random_.one_in(4) ? release() : create();
    case 2:
    case 3:
    case 4: return add_geometry();
    case 5: return add_group();
    case 6:
    case 7: return add_instance();
    case 8:
    case 9:
    case 10: return update();
    case 11:
    case 12: return remove();
    case 13:
    case 14:
    case 15:
    case 16: return commit();
    case 17:
    case 18: return ask_for_blockers();
    case 19: return ask_for_facts();
    case 20: return set_error_function();
    case 28:
    case 29:
    case 30:
    case 31: return move_arrays();
    default: return ask();
  }
}

penumbra_error Caller::create() {
  auto& slot = pool_.occluders[random_.below(pool_.occluders.size())];
  if (slot != 0 && !random_.one_in(5)) return commit();  // enough of them
  penumbra_occluders made{};
  const penumbra_error code = penumbra_create(&made);
  if (code != PENUMBRA_OK) return code;
  const penumbra_occluders before{slot.exchange(made.id)};
  if (before.id != 0) penumbra_release(before);
  return code;
}

penumbra_error Caller::release() { return penumbra_release(some_occluders()); }

penumbra_error Caller::add_geometry() {
  const penumbra_occluders to = some_occluders();
  const Arrays& a = arrays_;
  penumbra_geometry added{};
  penumbra_error code = PENUMBRA_OK;
  penumbra_geometry* const out = random_.one_in(100) ? nullptr : &added;
  // One after the other: arguments would be drawn in an order of the compiler's.
  const Rows v1 = random_vectors(a, random_), v2 = random_vectors(a, random_);
  const Rows n1 = random_numbers(a, random_), n2 = random_numbers(a, random_);
  const Rows faces = random_triangles(a, random_);
  switch (random_.below(is_alone_ ? 6 : 5)) {
    case 0: code = penumbra_add_spheres(to, v1, n1, out); break;
    case 1:
      code = penumbra_add_cones(to, v1, v2, n1, n2, random_.below(random_.one_in(50) ? 9 : 2), out);
      break;
    case 2: code = penumbra_add_disks(to, v1, v2, n1, random_.one_in(3) ? n2 : Rows{}, out); break;
    case 5: {  // alone: what will move
      const std::uint32_t i = random_.below(Arrays::sane), k = random_.below(Arrays::sane);
      const MovingMesh& mesh = arrays_.moving.emplace_back(a.vectors[i], a.triangles[k]);
      code = penumbra_add_triangles(to, {mesh.positions.data(), mesh.positions.size(), 0},
                                    {mesh.triangles.data(), mesh.triangles.size(), 0}, out);
      break;
    }
    default: code = penumbra_add_triangles(to, v1, faces, out); break;
  }
  if (code == PENUMBRA_OK) keep(pool_.geometries, to, added.id);
  return code;
}

penumbra_error Caller::add_group() {
  const penumbra_occluders to = some_occluders(), shapes = some_occluders();
  penumbra_group added{};
  const penumbra_error code = penumbra_add_group(to, shapes, &added);
  if (code == PENUMBRA_OK) keep(pool_.groups, to, added.id);
  return code;
}

penumbra_error Caller::add_instance() {
  const PartSlot& group = some_slot(pool_.groups);
  const penumbra_occluders to = owner_of(group);
  const auto placement = random_placement(random_);
  penumbra_instance added{};
  const penumbra_error code = penumbra_add_instance(
      to, {some_id(group)}, random_.one_in(100) ? nullptr : placement.data(), &added);
  if (code == PENUMBRA_OK) keep(pool_.instances, to, added.id);
  return code;
}

penumbra_error Caller::update() {
  const PartSlot& geometry = some_slot(pool_.geometries);
  const PartSlot& instance = some_slot(pool_.instances);
  const PartSlot& group = some_slot(pool_.groups);
  const Rows positions = random_vectors(arrays_, random_);
  switch (random_.below(3)) {
    case 0: return penumbra_move_geometry(owner_of(geometry), {some_id(geometry)}, positions);
    case 1:
      return penumbra_move_group(owner_of(group), {some_id(group)}, {some_id(geometry)}, positions);
    default: {
      const auto placement = random_placement(random_);
      return penumbra_move_instance(owner_of(instance), {some_id(instance)}, placement.data());
    }
  }
}

penumbra_error Caller::move_arrays() {
  if (arrays_.moving.empty()) return PENUMBRA_OK;
  MovingMesh& mesh = arrays_.moving[random_.below(arrays_.moving.size())];
  const Vec3f by = random_.in_cube() * random_.power(-3, 0);
  for (Vec3f& position : mesh.positions) position += random_.one_in(2) ? by : by * 0.5f;
  if (random_.one_in(4)) {  // other triangles, too
    auto& triangle = mesh.triangles[random_.below(mesh.triangles.size())];
    triangle[random_.below(3)] = random_.below(mesh.positions.size());
  }
  return PENUMBRA_OK;
}

penumbra_error Caller::remove() {
  const PartSlot& geometry = some_slot(pool_.geometries);
  const PartSlot& instance = some_slot(pool_.instances);
  const PartSlot& group = some_slot(pool_.groups);
  switch (random_.below(3)) {
    case 0: return penumbra_remove_geometry(owner_of(geometry), {some_id(geometry)});
    case 1: return penumbra_remove_instance(owner_of(instance), {some_id(instance)});
    default: return penumbra_remove_group(owner_of(group), {some_id(group)});
  }
}

penumbra_error Caller::commit() {
  const penumbra_occluders which = some_occluders();
  penumbra_commit_options options{};
  penumbra_default_commit_options(&options, sizeof options);
  options.may_refit = random_.below(random_.one_in(50) ? 9 : 2);
  penumbra_commit_report report{};
  report.struct_size = random_.one_in(100) ? random_.below(99) : sizeof report;
  const penumbra_error code = penumbra_commit(which, random_.one_in(2) ? &options : nullptr,
                                              random_.one_in(9) ? nullptr : &report);
  if (code != PENUMBRA_OK) return code;
  ++tally_.commits;
  tally_.refits += report.is_refitted;
  committed_ = which;
  return code;
}

penumbra_error Caller::ask() {
  const penumbra_occluders which = some_occluders();
  penumbra_points points = random_points(arrays_, random_);
  const penumbra_light light = random_light(arrays_, random_);
  penumbra_ask_options options = random_options(random_);
  if (random_.one_in(4)) {
    constexpr penumbra_progress_function all[]{go_on, cancel, call_again};
    options.progress = all[random_.below(std::size(all))];
  }
  if (options.shadow_samples > 1000) {  // takes long
    points.positions.count = std::min<std::size_t>(points.positions.count, 2);
    points.normals.count = std::min<std::size_t>(points.normals.count, 2);
  }
  const std::size_t count = std::min<std::size_t>(points.positions.count, 40000);
  const std::size_t room = random_.one_in(30) ? count / 2 : count;
  const std::size_t words = std::min<std::size_t>(options.shadow_samples / 32 + 1, 2048);
  penumbra_counters counters{};
  counters.struct_size = sizeof counters;
  const auto* by = random_.one_in(8) ? nullptr : &options;
  penumbra_counters* cost = random_.one_in(2) ? &counters : nullptr;
  switch (random_.below(4)) {
    case 0: {
      std::vector<std::uint8_t> out(room);
      return penumbra_classify(which, &points, &light, out.data(), room, by, cost);
    }
    case 1: {
      std::vector<float> out(room);
      const penumbra_error code =
          penumbra_visible_fraction(which, &points, &light, out.data(), room, by, cost);
      const auto is_share = [](float v) { return v >= 0 && v <= 1; };
      return std::all_of(out.begin(), out.end(), is_share) ? code : PENUMBRA_ERROR_INTERNAL;
    }
    case 2: {
      const std::size_t needed = by ? (options.shadow_samples + std::size_t{31}) / 32 : 1;
      std::vector<std::uint32_t> out(room * std::min(words, needed));
      return penumbra_visible_samples(which, &points, &light, out.data(), out.size(), by, cost);
    }
    default: {
      std::vector<penumbra_visibility_row> out(room);
      return penumbra_visibility(which, &points, &light, out.data(), room, by, cost);
    }
  }
}

penumbra_error Caller::ask_for_blockers() {
  const penumbra_occluders which = some_occluders();
  const penumbra_light light = random_light(arrays_, random_);
  const float a[3]{random_number(random_), random_number(random_), random_number(random_)};
  const float b[3]{random_number(random_), random_number(random_), random_number(random_)};
  std::uint32_t shadow_class = 0;
  std::size_t count = 0;
  if (random_.one_in(3)) {
    std::vector<float> ways(3 * std::size_t{random_.below(300)});
    const float* from = random_.one_in(100) ? nullptr : a;
    const std::size_t d = random_.one_in(50) ? 0 : ways.size() / 3;
    return penumbra_light_samples(&light, from, random_.below(9), 0, random_.below(3), ways.data(),
                                  d);
  }
  std::vector<penumbra_primitive> out(random_.below(100));
  if (random_.one_in(2)) {
    const float* const normal = random_.one_in(2) ? b : nullptr;
    return penumbra_blockers(which, a, normal, &light, &shadow_class, out.data(), out.size(),
                             &count);
  }
  const bool is_sorted = !random_.one_in(10);
  float lo[3], hi[3];
  for (int i = 0; i < 3; ++i) {
    lo[i] = is_sorted ? std::min(a[i], b[i]) : a[i];
    hi[i] = is_sorted ? std::max(a[i], b[i]) : b[i];
  }
  return penumbra_shaft(which, lo, hi, &light, &shadow_class, out.data(), out.size(), &count);
}

penumbra_error Caller::ask_for_facts() {
  const penumbra_occluders which = some_occluders();
  float lo[3], hi[3];
  std::uint64_t bytes = 0;
  if (random_.one_in(2)) return penumbra_memory_bytes(which, &bytes);
  return penumbra_bounds(which, lo, random_.one_in(50) ? nullptr : hi);
}

penumbra_error Caller::set_error_function() {
  const penumbra_occluders of = random_.one_in(3) ? penumbra_occluders{} : some_occluders();
  return penumbra_set_error_function(of, random_.one_in(4) ? nullptr : count_error,
                                     &pool_.told_errors);
}

}  // namespace penumbra::fuzz
