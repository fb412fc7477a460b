// An output file that appears whole or not at all.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "util/error.h"

namespace dapple {

// Writes to a temporary file in the target's folder; commit() flushes it to disk and renames it
// over the target. Without commit() nothing remains and an earlier file stays as it was; where the
// file system has files without names (Linux: O_TMPFILE) that is so even if the process is killed.
// A replaced file keeps its permissions; one that may not be written is not replaced. A symbolic
// link stays, the file it names is replaced. Targets that are not regular files (/dev/stdout,
// /dev/full, a pipe) are written in place.
//
// Errors: cannot_create when there can be no such file, io when writing fails half-way.
class AtomicFile {
 public:
  [[nodiscard]] static Expected<AtomicFile> create(const std::string& path);

  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&&) = delete;
  ~AtomicFile();

  [[nodiscard]] Status write(std::span<const std::byte> bytes);
  [[nodiscard]] Status commit();

  const std::string& path() const { return path_; }

 private:
  AtomicFile(std::string path, int descriptor, bool in_place);
  static Expected<AtomicFile> create_temporary(const std::string& path,
                                               std::optional<mode_t> permissions);
  void discard();

  std::string path_;
  std::string temporary_;  // empty while the file has no name, and when written in place
  int descriptor_ = -1;
  bool in_place_ = false;
};

// create, write and commit in one call.
[[nodiscard]] Status write_file_atomically(const std::string& path,
                                           std::span<const std::byte> bytes);

}  // namespace dapple
