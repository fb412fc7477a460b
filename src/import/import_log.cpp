#include "import/import_log.h"

#include <fmt/format.h>

#include <utility>

#include "import/limits.h"

namespace dapple {

void ImportLog::warn(std::string text) {
  if (seen_.contains(text)) return;
  if (warnings_.size() == kMaxWarnings) {
    ++left_out_;
    return;
  }
  seen_.insert(text);
  warnings_.push_back(std::move(text));
}

std::vector<std::string> ImportLog::take() {
  if (left_out_ > 0) warnings_.push_back(fmt::format("and {} further warnings", left_out_));
  seen_.clear();
  left_out_ = 0;
  return std::exchange(warnings_, {});
}

}  // namespace dapple
