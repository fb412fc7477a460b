// Where a library function sends text: it neither prints nor keeps it.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <functional>
#include <string_view>
#include <utility>

#include "util/error.h"

namespace dapple {

// Takes the next piece of a text; a failure ends the text there.
using TextSink = std::function<Status(std::string_view)>;

// Collects small pieces and hands them on in large ones, so that a text of any length takes
// bounded memory.
class TextWriter {
 public:
  explicit TextWriter(const TextSink& sink) : sink_(sink) {}

  template <class... Args>
  void print(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(buffer_), format, std::forward<Args>(args)...);
    if (buffer_.size() >= kPieceSize) hand_on();
  }

  // False once the sink has failed: what is printed after that is lost.
  bool good() const { return status_.has_value(); }

  // Hands on what is left; the first failure of the sink, if any.
  [[nodiscard]] Status finish() {
    hand_on();
    return status_;
  }

 private:
  static constexpr std::size_t kPieceSize = 1 << 16;

  void hand_on() {
    if (good() && buffer_.size() > 0) status_ = sink_({buffer_.data(), buffer_.size()});
    buffer_.clear();
  }

  const TextSink& sink_;
  fmt::memory_buffer buffer_;
  Status status_;
};

}  // namespace dapple
