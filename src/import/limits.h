// Limits on everything that a file counts. No honest file comes near them; a hostile one ends in an
// error before it takes memory or time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "util/error.h"

namespace dapple {

inline constexpr std::size_t kMaxWarnings = 100;
inline constexpr std::size_t kMaxNodes = 1u << 24;
inline constexpr std::size_t kMaxNodeDepth = 1u << 12;
inline constexpr std::size_t kMaxJsonDepth = 256;
inline constexpr std::uint64_t kMaxJsonBytes = 1ull << 30;
inline constexpr std::uint64_t kMaxVertexCount = 0xfffffff0u;   // vertex indices are 32 bits
inline constexpr std::uint64_t kMaxTriangleCount = 1ull << 31;  // as kMaxObjectCount
inline constexpr std::uint64_t kMaxImagePixels = 1ull << 28;
inline constexpr std::size_t kMaxMorphTargets = 4096;

// Memory that an import may still take.
class ByteBudget {
 public:
  explicit ByteBudget(std::uint64_t bytes) : left_(bytes), total_(bytes) {}

  // Takes count * size bytes, or fails; `what` names them in the error.
  [[nodiscard]] Status take(std::uint64_t count, std::uint64_t size, const std::string& what);

 private:
  std::uint64_t left_;
  std::uint64_t total_;
};

}  // namespace dapple
