// Which addresses are files mapped into memory: what a program needs to turn the signal that a
// truncated file raises (SIGBUS) into an ordinary failure.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace dapple {

// Remembers a mapping for as long as this lives. When kMaxMappedRanges are taken, further ones
// are not remembered.
class MappedRange {
 public:
  MappedRange() = default;
  MappedRange(std::span<const std::byte> bytes, const std::string& path);
  MappedRange(MappedRange&& other) noexcept;
  MappedRange& operator=(MappedRange&& other) noexcept;
  ~MappedRange();

 private:
  int slot_ = -1;
};

inline constexpr int kMaxMappedRanges = 64;

// For programs, never called by the library: from now on, reading a mapped file beyond its end
// because it was truncated meanwhile writes one line that names the file to standard error and
// ends the process with `exit_code`. Any other SIGBUS does what it did before.
void exit_when_mapped_file_shrinks(int exit_code);

}  // namespace dapple
