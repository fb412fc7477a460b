// Errors that many threads find in one file.
#pragma once

#include <compare>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include "scene_file/section_table.h"
#include "util/error.h"

namespace dapple {

// Of all errors that are found in parallel the one that stands first in the file.
class FirstFault {
 public:
  void report(std::uint64_t offset, const std::string& reason) {
    const std::lock_guard lock(mutex_);
    const Fault fault{offset, reason};
    if (!fault_ || fault < *fault_) fault_ = fault;
  }
  Status status() const {
    if (!fault_) return {};
    return damaged_at(fault_->offset, fault_->reason);
  }

 private:
  struct Fault {
    std::uint64_t offset;
    std::string reason;
    // clang-tidy takes the comparison with zero that the compiler writes for a null pointer.
    friend auto operator<=>(const Fault&, const Fault&) = default;  // NOLINT(modernize-use-nullptr)
  };
  std::mutex mutex_;
  std::optional<Fault> fault_;
};

}  // namespace dapple
