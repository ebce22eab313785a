// SPDX-License-Identifier: MIT
// Handles of the C API, and what they stand for.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "penumbra/penumbra_c.h"
#include "penumbra/visibility/occluders.h"

namespace penumbra {

enum class HandleKind : std::uint8_t { occluders = 1, geometry, group, instance };

/// Parts of occluders of one kind, whose handles have been given. A handle holds, from its highest
/// bit: 4 bits of kind; 28 of the owner's serial number, the same for two owners only where 2^28
/// were made in between; 32 of number.
class Parts {
 public:
  Parts(HandleKind kind, std::uint64_t owner) : kind_(kind), owner_(owner) {}

  /// So that the next `give` does not throw.
  void reserve_one();
  /// The handle of a part that was added.
  std::uint64_t give(std::uint32_t number) noexcept;
  /// The number of a part that was added and not removed. Throws ApiError.
  std::uint32_t number_of(std::uint64_t handle) const;
  void remove(std::uint32_t number) { is_there_[number] = false; }

 private:
  HandleKind kind_;
  std::uint64_t owner_;
  std::vector<bool> is_there_;
};

/// The number of a geometry of the occluders of that serial number, be it there or not. Throws
/// ApiError.
std::uint32_t geometry_number(penumbra_geometry geometry, std::uint64_t owner);

struct ErrorFunction {
  penumbra_error_function call = nullptr;
  void* user = nullptr;
};

/// What a `penumbra_occluders` stands for.
struct ApiObject {
  explicit ApiObject(std::uint64_t serial_number) : serial(serial_number) {}

  std::uint64_t serial;
  Occluders occluders;
  std::atomic<bool> is_committed = false;

  std::mutex parts_mutex;  // held by all that adds, updates and removes; not by commits
  Parts geometries{HandleKind::geometry, serial};
  Parts groups{HandleKind::group, serial};
  Parts instances{HandleKind::instance, serial};
  std::vector<std::uint64_t> group_sources;  // serial numbers

  std::mutex error_mutex;
  ErrorFunction error_function;
};

penumbra_occluders make_object();
/// Keeps it alive while it is held. Throws ApiError.
std::shared_ptr<ApiObject> object_of(penumbra_occluders occluders);
void release_object(penumbra_occluders occluders);

/// Handle {0}: for those that have none.
void set_error_function(penumbra_occluders occluders, ErrorFunction function);
/// That of the occluders, or else that of {0}.
ErrorFunction error_function_of(penumbra_occluders occluders);

}  // namespace penumbra
