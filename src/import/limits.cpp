#include "import/limits.h"

#include <fmt/format.h>

namespace dapple {

Status ByteBudget::take(std::uint64_t count, std::uint64_t size, const std::string& what) {
  std::uint64_t bytes = 0;
  if (__builtin_mul_overflow(count, size, &bytes) || bytes > left_) {
    return fail(Errc::bad_data, what,
                fmt::format("{} times {} bytes: together more than the {} bytes that an import may "
                            "take",
                            count, size, total_));
  }
  left_ -= bytes;
  return {};
}

}  // namespace dapple
