// The hash of a section: a tree of one level, so that pieces can be hashed by many threads.
#pragma once

#include <cstdint>
#include <span>

#include "scene_file/format.h"
#include "util/hash.h"

namespace dapple {

constexpr std::size_t hash_chunk_count(std::uint64_t size) {
  return static_cast<std::size_t>((size + kHashChunk - 1) / kHashChunk);
}

// Of the hashes of the chunks in order.
inline std::uint64_t hash_of_chunks(std::span<const std::uint64_t> chunk_hashes) {
  return hash_bytes(std::as_bytes(chunk_hashes));
}

}  // namespace dapple
