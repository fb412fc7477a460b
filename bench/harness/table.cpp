#include "harness/table.h"

#include <fmt/format.h>

#include <algorithm>

namespace dapple::bench {
namespace {

std::string join_cells(const std::vector<std::string>& cells,
                       const std::vector<std::size_t>& widths, const char* begin,
                       const char* between, const char* end) {
  std::string line = begin;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) line += between;
    line += i == 0 ? fmt::format("{:<{}}", cells[i], widths[i])
                   : fmt::format("{:>{}}", cells[i], widths[i]);
  }
  return line + end + "\n";
}

}  // namespace

std::vector<std::size_t> Table::widths() const {
  std::vector<std::size_t> result(header_.size(), 3);
  const auto widen = [&](const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) result[i] = std::max(result[i], cells[i].size());
  };
  widen(header_);
  for (const auto& row : rows_) widen(row);
  return result;
}

std::string Table::text() const {
  const auto width = widths();
  std::string result = join_cells(header_, width, "", "  ", "");
  for (const auto& row : rows_) result += join_cells(row, width, "", "  ", "");
  return result;
}

std::string Table::markdown() const {
  const auto width = widths();
  std::string result = join_cells(header_, width, "| ", " | ", " |");
  std::vector<std::string> rule;
  for (std::size_t i = 0; i < width.size(); ++i) {
    rule.push_back(std::string(width[i] - (i > 0 ? 1 : 0), '-') + (i > 0 ? ":" : ""));
  }
  result += join_cells(rule, width, "| ", " | ", " |");
  for (const auto& row : rows_) result += join_cells(row, width, "| ", " | ", " |");
  return result;
}

}  // namespace dapple::bench
