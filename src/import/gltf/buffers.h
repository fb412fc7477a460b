// Buffers and the views into them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "import/gltf/context.h"
#include "util/mapped_file.h"

namespace dapple::gltf {

// Loads every buffer; one that is missing fails at once or, with keep_going, when it is read.
class Buffers {
 public:
  [[nodiscard]] static Expected<Buffers> load(const Context& context);

  // The bytes of a view, decompressed where EXT_meshopt_compression says so.
  [[nodiscard]] Expected<std::span<const std::byte>> view(std::uint32_t index);
  const Context& context() const { return *context_; }

 private:
  explicit Buffers(const Context& context) : context_(&context) {}
  struct Buffer {
    std::span<const std::byte> bytes;
    MappedFile file;
    std::vector<std::uint8_t> data;
    bool is_missing = false;
  };
  [[nodiscard]] Expected<Buffer> load_buffer(std::size_t index) const;
  [[nodiscard]] Expected<std::span<const std::byte>> slice(const JsonValue& view,
                                                           const std::string& place) const;
  [[nodiscard]] Expected<std::span<const std::byte>> unpacked(std::uint32_t index,
                                                              const JsonValue& packed);

  const Context* context_;
  std::vector<Buffer> buffers_;
  std::map<std::uint32_t, std::vector<std::byte>> unpacked_;
};

}  // namespace dapple::gltf
