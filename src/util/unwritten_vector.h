// A std::vector of plain data whose resize() leaves new elements as the memory was: for large
// arrays all of whose elements are written before they are read.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace dapple {

// Operator new, on huge pages where they fit in. Memory that was freed may serve again (of glibc,
// up to 32 MiB), unlike that of a HugeArray, which the system clears anew.
[[nodiscard]] void* allocate_unwritten(std::size_t bytes);

template <class T>
struct UnwrittenAllocator {
  static_assert(std::is_trivially_copyable_v<T>);
  static_assert(alignof(T) <= __STDCPP_DEFAULT_NEW_ALIGNMENT__);
  using value_type = T;

  UnwrittenAllocator() = default;
  template <class U>
  UnwrittenAllocator(const UnwrittenAllocator<U>&) {}

  T* allocate(std::size_t count) {
    if (count > static_cast<std::size_t>(-1) / sizeof(T)) throw std::bad_array_new_length();
    return static_cast<T*>(allocate_unwritten(count * sizeof(T)));
  }
  void deallocate(T* address, std::size_t) noexcept { ::operator delete(address); }
  void construct(T*) {}
  template <class... Args>
  void construct(T* address, Args&&... args) {
    std::construct_at(address, std::forward<Args>(args)...);
  }
  friend bool operator==(const UnwrittenAllocator&, const UnwrittenAllocator&) { return true; }
};

template <class T>
using UnwrittenVector = std::vector<T, UnwrittenAllocator<T>>;

}  // namespace dapple
