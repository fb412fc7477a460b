// Content hashes: XXH3, 64 bits, the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace dapple {

[[nodiscard]] std::uint64_t hash_bytes(std::span<const std::byte> bytes);

}  // namespace dapple
