// A file mapped read-only into memory.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "util/error.h"
#include "util/mapped_ranges.h"

namespace dapple {

// Anything that is not a regular file (a directory, a device, a pipe) is refused.
class MappedFile {
 public:
  [[nodiscard]] static Expected<MappedFile> open(const std::string& path);
  // A copy of the file in memory, sealed: what others do to the file then no longer matters.
  [[nodiscard]] static Expected<MappedFile> open_copy(const std::string& path);
  // Of an open file, which stays open; `path` is its name in errors.
  [[nodiscard]] static Expected<MappedFile> map(int descriptor, const std::string& path);

  MappedFile() = default;
  MappedFile(MappedFile&& other) noexcept;
  MappedFile& operator=(MappedFile&& other) noexcept;
  ~MappedFile();

  std::span<const std::byte> bytes() const { return bytes_; }

 private:
  MappedFile(std::span<const std::byte> bytes, const std::string& path)
      : bytes_(bytes), range_(bytes, path) {}

  std::span<const std::byte> bytes_;
  MappedRange range_;
};

}  // namespace dapple
