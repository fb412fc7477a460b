#include "util/huge_array.h"

#include <sys/mman.h>

#include <cstdint>
#include <new>

namespace dapple {
namespace {

constexpr std::size_t kPage = 4096;

std::size_t round_up(std::size_t bytes, std::size_t unit) {
  return (bytes + unit - 1) / unit * unit;
}

std::size_t mapped_size(std::size_t bytes) {
  return round_up(bytes, bytes >= kHugePage ? kHugePage : kPage);
}

}  // namespace

void* allocate_pages(std::size_t bytes) {
  const std::size_t size = mapped_size(bytes);
  const std::size_t slack = bytes >= kHugePage ? kHugePage : 0;
  if (size < bytes || size + slack < size) throw std::bad_alloc();
  void* address = ::mmap(nullptr, size + slack, PROT_READ | PROT_WRITE,
                         MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (address == MAP_FAILED) throw std::bad_alloc();
  if (slack == 0) return address;
  // Give back what lies before the first huge page boundary and after the end.
  const auto begin = reinterpret_cast<std::uintptr_t>(address);
  const std::uintptr_t aligned = round_up(begin, kHugePage);
  if (aligned != begin) ::munmap(address, aligned - begin);
  const std::size_t rest = begin + slack - aligned;
  if (rest != 0) ::munmap(reinterpret_cast<void*>(aligned + size), rest);
  ::madvise(reinterpret_cast<void*>(aligned), size, MADV_HUGEPAGE);  // a wish; may be refused
  return reinterpret_cast<void*>(aligned);
}

void free_pages(void* address, std::size_t bytes) noexcept {
  ::munmap(address, mapped_size(bytes));
}

void forget_pages(void* address, std::size_t bytes) noexcept {
  const auto begin = reinterpret_cast<std::uintptr_t>(address);
  const std::uintptr_t first = round_up(begin, kPage), end = (begin + bytes) / kPage * kPage;
  if (first < end) ::madvise(reinterpret_cast<void*>(first), end - first, MADV_DONTNEED);
}

}  // namespace dapple
