// What moving so many bytes costs at least: the yardsticks for storing and loading.
#pragma once

#include <cstddef>
#include <string>

#include "util/error.h"

namespace dapple::bench {

enum class Flush { no, yes };

// Copies `bytes` bytes from one place in memory to another, in blocks that the caches do not hold.
void copy_in_memory(std::size_t bytes);

// Writes so many bytes in large blocks, and waits for the disk if asked to; then removes the file,
// which is part of the time.
[[nodiscard]] Status write_plain(const std::string& path, std::size_t bytes, Flush flush);

// Reads the whole file in large blocks.
[[nodiscard]] Status read_plain(const std::string& path);

}  // namespace dapple::bench
