#include "import/assimp/sandbox_files.h"

#include <algorithm>
#include <cstring>
#include <string>

namespace dapple::assimp {
namespace {

class MappedStream final : public Assimp::IOStream {
 public:
  explicit MappedStream(MappedFile file) : file_(std::move(file)) {}

  std::size_t Read(void* buffer, std::size_t size, std::size_t count) override {
    if (size == 0) return 0;
    const std::size_t whole = std::min(count, (file_.bytes().size() - position_) / size);
    if (whole > 0) std::memcpy(buffer, file_.bytes().data() + position_, whole * size);
    position_ += whole * size;
    return whole;
  }
  std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
  aiReturn Seek(std::size_t offset, aiOrigin origin) override {
    const std::size_t size = file_.bytes().size();
    const std::size_t base = origin == aiOrigin_CUR ? position_ : origin == aiOrigin_END ? size : 0;
    // Backwards from the end and from here are given as numbers that wrap around.
    const std::size_t target = base + offset;
    if (target > size) return aiReturn_FAILURE;
    position_ = target;
    return aiReturn_SUCCESS;
  }
  std::size_t Tell() const override { return position_; }
  std::size_t FileSize() const override { return file_.bytes().size(); }
  void Flush() override {}

 private:
  MappedFile file_;
  std::size_t position_ = 0;
};

std::string relative(const char* name) {
  std::string text(name);
  std::ranges::replace(text, '\\', '/');
  while (text.starts_with("./")) text.erase(0, 2);
  return text;
}

}  // namespace

bool SandboxFiles::Exists(const char* name) const {
  return sandbox_.open(relative(name)).has_value();
}

Assimp::IOStream* SandboxFiles::Open(const char* name, const char* mode) {
  if (std::strchr(mode, 'w') != nullptr || std::strchr(mode, 'a') != nullptr) return nullptr;
  auto file = sandbox_.open(relative(name));
  return file ? new MappedStream(std::move(*file)) : nullptr;
}

void SandboxFiles::Close(Assimp::IOStream* stream) { delete stream; }

}  // namespace dapple::assimp
