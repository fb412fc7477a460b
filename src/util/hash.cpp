#include "util/hash.h"

// libxxhash carries XXH3 for every vector width and picks one at run time on x86; elsewhere the
// width is that of the compiler's target. The value does not depend on it.
#if defined(__x86_64__)
#include <xxh_x86dispatch.h>
#else
#include <xxhash.h>
#endif

namespace dapple {

std::uint64_t hash_bytes(std::span<const std::byte> bytes) {
  return XXH3_64bits(bytes.data(), bytes.size());
}

}  // namespace dapple
