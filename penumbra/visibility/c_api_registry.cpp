// SPDX-License-Identifier: MIT
#include "penumbra/visibility/c_api_registry.h"

#include <shared_mutex>
#include <string>
#include <unordered_map>
#include <utility>

#include "penumbra/visibility/c_api_error.h"

namespace penumbra {
namespace {

constexpr int kind_shift = 60, owner_shift = 32;
constexpr std::uint64_t serial_mask = (std::uint64_t{1} << kind_shift) - 1;
constexpr std::uint64_t owner_mask = (std::uint64_t{1} << (kind_shift - owner_shift)) - 1;

[[noreturn]] void refuse_handle(std::string message) {
  throw ApiError{PENUMBRA_ERROR_INVALID_HANDLE, std::move(message)};
}

const char* name_of(HandleKind kind) {
  switch (kind) {
    case HandleKind::occluders: return "occluders";
    case HandleKind::geometry: return "a geometry";
    case HandleKind::group: return "a group";
    case HandleKind::instance: return "an instance";
  }
  return "something else";
}

std::uint64_t handle_of(HandleKind kind, std::uint64_t rest) {
  return static_cast<std::uint64_t>(kind) << kind_shift | rest;
}

void check_kind(std::uint64_t handle, HandleKind wanted) {
  const auto kind = static_cast<HandleKind>(handle >> kind_shift);
  if (kind == wanted) return;
  if (kind < HandleKind::occluders || kind > HandleKind::instance)
    refuse_handle("a handle that penumbra never gave; use what create and add gave");
  refuse_handle(std::string("the handle of ") + name_of(kind) + " in the place of " +
                name_of(wanted));
}

std::uint32_t part_number(std::uint64_t handle, HandleKind kind, std::uint64_t owner) {
  check_kind(handle, kind);
  if ((handle >> owner_shift & owner_mask) != (owner & owner_mask))
    refuse_handle(std::string(name_of(kind)) + " of other occluders; use those that it is of");
  return static_cast<std::uint32_t>(handle);
}

/// The one global: C hands over numbers, and only what knows all that were given can tell a live
/// one from any other without a look at memory that may be gone. Serial numbers are not used twice.
struct Registry {
  std::shared_mutex mutex;
  std::unordered_map<std::uint64_t, std::shared_ptr<ApiObject>> objects;  // by serial number
  std::uint64_t last_serial = 0;
  ErrorFunction error_function;
};

Registry& registry() {
  // Never destroyed: threads may call while the program ends.
  static Registry& all = *new Registry;
  return all;
}

std::shared_ptr<ApiObject> find(std::uint64_t serial) {
  Registry& all = registry();
  const std::shared_lock lock(all.mutex);
  const auto found = all.objects.find(serial);
  return found == all.objects.end() ? nullptr : found->second;
}

}  // namespace

void Parts::reserve_one() {
  // By doubling: vectors reserve what they are told and no more.
  if (is_there_.size() == is_there_.capacity()) is_there_.reserve(2 * is_there_.size() + 64);
}

std::uint64_t Parts::give(std::uint32_t number) noexcept {
  is_there_.resize(number + std::size_t{1}, true);
  return handle_of(kind_, (owner_ & owner_mask) << owner_shift | number);
}

std::uint32_t Parts::number_of(std::uint64_t handle) const {
  const std::uint32_t number = part_number(handle, kind_, owner_);
  if (number >= is_there_.size()) refuse_handle("a handle that penumbra never gave");
  if (!is_there_[number])
    refuse_handle(std::string("the handle of ") + name_of(kind_) + " that was removed");
  return number;
}

std::uint32_t geometry_number(penumbra_geometry geometry, std::uint64_t owner) {
  return part_number(geometry.id, HandleKind::geometry, owner);
}

penumbra_occluders make_object() {
  Registry& all = registry();
  std::uint64_t serial = 0;
  {
    const std::unique_lock lock(all.mutex);
    serial = ++all.last_serial;
  }
  auto object = std::make_shared<ApiObject>(serial);
  const std::unique_lock lock(all.mutex);
  all.objects.emplace(serial, std::move(object));
  return {handle_of(HandleKind::occluders, serial)};
}

std::shared_ptr<ApiObject> object_of(penumbra_occluders occluders) {
  check_kind(occluders.id, HandleKind::occluders);
  std::shared_ptr<ApiObject> object = find(occluders.id & serial_mask);
  if (!object) refuse_handle("occluders that were released, or never created");
  return object;
}

void release_object(penumbra_occluders occluders) {
  check_kind(occluders.id, HandleKind::occluders);
  Registry& all = registry();
  std::shared_ptr<ApiObject> object;  // destroyed without the lock
  const std::unique_lock lock(all.mutex);
  const auto found = all.objects.find(occluders.id & serial_mask);
  if (found == all.objects.end()) refuse_handle("occluders that were released, or never created");
  object = std::move(found->second);
  all.objects.erase(found);
}

void set_error_function(penumbra_occluders occluders, ErrorFunction function) {
  if (occluders.id == 0) {
    Registry& all = registry();
    const std::unique_lock lock(all.mutex);
    all.error_function = function;
    return;
  }
  const std::shared_ptr<ApiObject> object = object_of(occluders);
  const std::lock_guard lock(object->error_mutex);
  object->error_function = function;
}

ErrorFunction error_function_of(penumbra_occluders occluders) {
  if (occluders.id >> kind_shift == static_cast<std::uint64_t>(HandleKind::occluders)) {
    if (const std::shared_ptr<ApiObject> object = find(occluders.id & serial_mask)) {
      const std::lock_guard lock(object->error_mutex);
      if (object->error_function.call) return object->error_function;
    }
  }
  Registry& all = registry();
  const std::shared_lock lock(all.mutex);
  return all.error_function;
}

}  // namespace penumbra
