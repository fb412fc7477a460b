// The numbers after the header of a PLY file, one after the other.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "import/ply/header.h"

namespace dapple::ply {

// A value that is not there or no number is 0 and makes the reader bad for good, so that callers
// ask once a row.
class ValueReader {
 public:
  ValueReader(std::span<const std::byte> bytes, const Header& header, std::string_view name);

  double next(Type type);
  // The length of a list, checked against what is left of the file.
  std::size_t next_count(const Property& list);
  void skip(const Property& property);

  bool bad() const { return bad_; }
  [[nodiscard]] tl::unexpected<Error> error(std::string message) const;
  [[nodiscard]] tl::unexpected<Error> error() const { return error(reason_); }

 private:
  double next_word(Type type);
  double next_bytes(Type type);
  double give_up(const char* reason);

  std::span<const std::byte> bytes_;
  std::string_view name_;
  Format format_;
  std::size_t position_;
  std::size_t line_;
  bool bad_ = false;
  const char* reason_ = "";
};

}  // namespace dapple::ply
