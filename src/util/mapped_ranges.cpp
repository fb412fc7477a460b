#include "util/mapped_ranges.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <utility>

namespace dapple {
namespace {

constexpr std::size_t kMaxNameLength = 255;

// Read by a signal handler, so: no locks, no allocation. `begin` is written last and cleared
// first; it is null while a slot is free or being filled.
struct Slot {
  std::atomic<bool> taken{false};
  std::atomic<const std::byte*> begin{nullptr};
  std::size_t size = 0;
  std::array<char, kMaxNameLength + 1> name{};
};

std::array<Slot, kMaxMappedRanges> slots;
std::atomic<int> exit_code_of_handler{0};
struct sigaction previous_action;

void write_text(const char* text) {
  [[maybe_unused]] const auto ignored = ::write(STDERR_FILENO, text, std::strlen(text));
}

const Slot* find_slot(const void* address) {
  const auto wanted = reinterpret_cast<std::uintptr_t>(address);
  for (const Slot& slot : slots) {
    const auto begin = reinterpret_cast<std::uintptr_t>(slot.begin.load());
    if (begin != 0 && wanted >= begin && wanted - begin < slot.size) return &slot;
  }
  return nullptr;
}

void on_bus_error(int, siginfo_t* info, void*) {
  if (const Slot* slot = find_slot(info->si_addr)) {
    write_text(slot->name.data());
    write_text(": the file was truncated while it was being read\n");
    ::_exit(exit_code_of_handler.load());
  }
  ::sigaction(SIGBUS, &previous_action, nullptr);  // the instruction runs again and is dealt with
}

}  // namespace

MappedRange::MappedRange(std::span<const std::byte> bytes, const std::string& path) {
  for (int i = 0; i < kMaxMappedRanges; ++i) {
    Slot& slot = slots[static_cast<std::size_t>(i)];
    if (slot.taken.exchange(true)) continue;
    const std::size_t length = std::min(path.size(), kMaxNameLength);
    path.copy(slot.name.data(), length);
    slot.name[length] = '\0';
    slot.size = bytes.size();
    slot.begin.store(bytes.data());
    slot_ = i;
    return;
  }
}

MappedRange::MappedRange(MappedRange&& other) noexcept : slot_(std::exchange(other.slot_, -1)) {}

MappedRange& MappedRange::operator=(MappedRange&& other) noexcept {
  std::swap(slot_, other.slot_);
  return *this;
}

MappedRange::~MappedRange() {
  if (slot_ < 0) return;
  Slot& slot = slots[static_cast<std::size_t>(slot_)];
  slot.begin.store(nullptr);
  slot.taken.store(false);
}

void exit_when_mapped_file_shrinks(int exit_code) {
  const bool installed = exit_code_of_handler.exchange(exit_code) != 0;
  if (installed) return;
  struct sigaction action {};
  action.sa_sigaction = on_bus_error;
  action.sa_flags = SA_SIGINFO;
  sigemptyset(&action.sa_mask);
  ::sigaction(SIGBUS, &action, &previous_action);
}

}  // namespace dapple
