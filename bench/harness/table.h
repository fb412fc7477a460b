// Tables for people: aligned columns, or Markdown.
#pragma once

#include <string>
#include <vector>

namespace dapple::bench {

class Table {
 public:
  explicit Table(std::vector<std::string> header) : header_(std::move(header)) {}

  // As many cells as the header has.
  void add_row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }

  // The first column is aligned to the left, the others to the right.
  std::string text() const;
  std::string markdown() const;

 private:
  std::vector<std::size_t> widths() const;

  std::vector<std::string> header_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace dapple::bench
