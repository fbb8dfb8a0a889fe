#pragma once

#include <cstddef>
#include <memory>
#include <utility>

namespace lightbench {

/// Bytes that are zero: fresh pages of the system where there are many of them, so that what nobody writes
/// takes no memory. Throws std::bad_alloc.
void* allocate_zeroed(std::size_t bytes);
void free_zeroed(void* memory, std::size_t bytes);

/// For vectors of plain numbers that begin as zeros and are large: resize() takes the zeros as the system
/// gives them instead of writing them. A vector that was made smaller must not be made larger again.
template <typename T>
struct ZeroedAllocator {
  using value_type = T;

  ZeroedAllocator() = default;
  template <typename U>
  ZeroedAllocator(const ZeroedAllocator<U>&) {}  // NOLINT(google-explicit-constructor): as allocators convert

  T* allocate(std::size_t count) { return static_cast<T*>(allocate_zeroed(count * sizeof(T))); }
  void deallocate(T* memory, std::size_t count) { free_zeroed(memory, count * sizeof(T)); }

  template <typename U>
  void construct(U*) {}
  template <typename U, typename... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    std::construct_at(place, std::forward<Arguments>(arguments)...);
  }

  friend bool operator==(const ZeroedAllocator&, const ZeroedAllocator&) { return true; }
};

}  // namespace lightbench
