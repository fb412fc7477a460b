// Any bytes as a glTF file: an error or a valid scene, never a crash. The bytes are a file of a
// folder of their own, so references lead nowhere.
#include <fcntl.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "import/registry.h"
#include "scene/validate.h"

namespace {

// Removed by nobody: it is one small file for the whole run.
const std::string& file_path() {
  static const std::string path = [] {
    std::string folder = "/dev/shm/gltf-fuzz-XXXXXX";
    if (::mkdtemp(folder.data()) == nullptr) std::abort();
    return folder + "/input.gltf";
  }();
  return path;
}

void write_input(const std::uint8_t* data, std::size_t size) {
  const int file = ::open(file_path().c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (file < 0 || ::write(file, data, size) != static_cast<ssize_t>(size)) std::abort();
  ::close(file);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  write_input(data, size);
  for (const bool keep_going : {false, true}) {
    dapple::ImportOptions options;
    options.keep_going = keep_going;
    options.max_bytes = 1 << 26;
    if (keep_going) options.time = 0.5;
    const auto result = dapple::import_scene(file_path(), options);
    if (result && !dapple::validate(result->scene)) std::abort();
  }
  return 0;
}
