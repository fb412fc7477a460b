// The folder of an imported file. Names inside the file lead nowhere else: neither by "..", nor by
// an absolute path, nor through a symbolic link.
#pragma once

#include <string>
#include <string_view>

#include "util/error.h"
#include "util/mapped_file.h"

namespace dapple {

class Sandbox {
 public:
  // The folder that holds the file `path`.
  [[nodiscard]] static Expected<Sandbox> around(const std::string& path);

  Sandbox(Sandbox&& other) noexcept;
  Sandbox& operator=(Sandbox&& other) noexcept;
  ~Sandbox();

  // A regular file below the folder; `name` is relative to it, with slashes.
  [[nodiscard]] Expected<MappedFile> open(const std::string& name) const;
  // What errors call it: the folder and the name.
  [[nodiscard]] std::string path_of(std::string_view name) const;

 private:
  Sandbox(int descriptor, std::string folder)
      : descriptor_(descriptor), folder_(std::move(folder)) {}

  int descriptor_ = -1;
  std::string folder_;
};

}  // namespace dapple
