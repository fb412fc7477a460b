#include "capi/last_error.h"

#include <algorithm>

namespace dapple {
namespace {

constexpr std::size_t kRoom = 1024;
thread_local char text_of_thread[kRoom] = "";

}  // namespace

void set_last_error(std::string_view text) noexcept {
  const std::size_t length = std::min(text.size(), kRoom - 1);
  std::copy_n(text.data(), length, text_of_thread);
  text_of_thread[length] = '\0';
}

const char* last_error() noexcept { return text_of_thread; }

}  // namespace dapple
