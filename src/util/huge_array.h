// Large arrays of plain data on huge pages, uninitialised until written.
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>

namespace dapple {

inline constexpr std::size_t kHugePage = std::size_t{2} << 20;

// Anonymous memory, zero when first read; aligned to a huge page when it is at least one, else to
// a cache line. Throws std::bad_alloc.
[[nodiscard]] void* allocate_pages(std::size_t bytes);
void free_pages(void* address, std::size_t bytes) noexcept;
// Gives the whole pages in that memory back to the system; their content is lost.
void forget_pages(void* address, std::size_t bytes) noexcept;

template <class T>
class HugeArray {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  HugeArray() = default;
  explicit HugeArray(std::size_t size)
      : data_(size == 0 ? nullptr : static_cast<T*>(allocate_pages(size * sizeof(T)))),
        size_(size) {}
  HugeArray(HugeArray&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}
  HugeArray& operator=(HugeArray&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    return *this;
  }
  ~HugeArray() {
    if (data_ != nullptr) free_pages(data_, size_ * sizeof(T));
  }

  T* data() { return data_; }
  const T* data() const { return data_; }
  std::size_t size() const { return size_; }
  std::size_t bytes() const { return size_ * sizeof(T); }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  std::span<T> span() { return {data_, size_}; }
  // Elements [begin, end) are not needed any more, though the array stays.
  void forget(std::size_t begin, std::size_t end) noexcept {
    forget_pages(data_ + begin, (end - begin) * sizeof(T));
  }
  std::span<const T> span() const { return {data_, size_}; }

 private:
  T* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace dapple
