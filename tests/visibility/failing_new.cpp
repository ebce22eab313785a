// SPDX-License-Identifier: MIT
#include "tests/visibility/failing_new.h"

#include <cstdlib>
#include <new>

namespace {

constexpr std::int64_t never = -1;
thread_local std::int64_t calls_left = never;

/// Whether this call is the one that fails.
bool is_time() { return calls_left != never && calls_left-- == 0; }

void* try_to_allocate(std::size_t size) noexcept {
  return is_time() ? nullptr : std::malloc(size == 0 ? 1 : size);
}

void* allocate(std::size_t size) {
  void* const memory = try_to_allocate(size);
  if (!memory) throw std::bad_alloc();
  return memory;
}

void* allocate(std::size_t size, std::align_val_t alignment) {
  const auto to = static_cast<std::size_t>(alignment);
  void* const memory = is_time() ? nullptr : std::aligned_alloc(to, (size + to - 1) / to * to);
  if (!memory) throw std::bad_alloc();
  return memory;
}

}  // namespace

// The other forms of the standard library call these; the sanitizers' do not.
void* operator new(std::size_t size) { return allocate(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return try_to_allocate(size);
}
void* operator new(std::size_t size, std::align_val_t to) {
  return allocate(size == 0 ? 1 : size, to);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace penumbra {

FailingNew::FailingNew(std::uint32_t calls) { calls_left = calls; }
FailingNew::~FailingNew() { calls_left = never; }

}  // namespace penumbra
