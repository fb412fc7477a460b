#include "import/gltf/container.h"

#include <fmt/format.h>

#include <cstdint>

namespace dapple::gltf {
namespace {

constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;
constexpr std::uint32_t kJsonChunk = 0x4e4f534a;
constexpr std::uint32_t kBinChunk = 0x004e4942;

std::uint32_t little_endian(std::span<const std::byte> bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;)
    value = value << 8 | std::to_integer<std::uint32_t>(bytes[at + i]);
  return value;
}

tl::unexpected<Error> bad(std::size_t byte, std::string message) {
  return fail(Errc::bad_data, fmt::format("byte {}", byte), std::move(message));
}

std::string_view text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

struct Chunk {
  std::uint32_t type = 0;
  std::span<const std::byte> data;
  std::size_t end = 0;
};

Expected<Chunk> chunk_at(std::span<const std::byte> file, std::size_t at) {
  if (file.size() - at < kChunkHeaderBytes) return bad(at, "the file ends within a chunk's header");
  const std::uint32_t length = little_endian(file, at);
  if (length > file.size() - at - kChunkHeaderBytes) return bad(at, "a chunk leaves the file");
  if (length % 4 != 0) return bad(at, "the length of a chunk is no multiple of 4");
  const std::size_t begin = at + kChunkHeaderBytes;
  return Chunk{little_endian(file, at + 4), file.subspan(begin, length), begin + length};
}

Status check_header(std::span<const std::byte> file) {
  if (file.size() < kHeaderBytes) return bad(file.size(), "the file ends within its header");
  const std::uint32_t version = little_endian(file, 4);
  if (version != 2) return bad(4, fmt::format("version {} of the container is not 2", version));
  const std::uint32_t length = little_endian(file, 8);
  if (length > file.size() || length < kHeaderBytes) {
    return bad(8, fmt::format("the header says {} bytes, the file has {}", length, file.size()));
  }
  return {};
}

// The chunk in second place, or later ones of unknown type, which are ignored.
Status add_chunk(const Chunk& chunk, std::size_t number, std::size_t at, Container& container) {
  if (chunk.type == kJsonChunk) return bad(at, "a second JSON chunk");
  if (chunk.type != kBinChunk) return {};
  if (container.bin) return bad(at, "a second BIN chunk");
  if (number != 1) return bad(at, "the BIN chunk is not the second one");
  container.bin = chunk.data;
  return {};
}

}  // namespace

Expected<Container> split_container(std::span<const std::byte> file) {
  Container container;
  if (!text_of(file).starts_with("glTF")) {
    container.text = text_of(file);
    return container;
  }
  container.is_binary = true;
  if (auto checked = check_header(file); !checked) return tl::unexpected(checked.error());
  file = file.first(little_endian(file, 8));
  std::size_t at = kHeaderBytes;
  for (std::size_t number = 0; number == 0 || at < file.size(); ++number) {
    const auto chunk = chunk_at(file, at);
    if (!chunk) return tl::unexpected(chunk.error());
    if (number == 0 && chunk->type != kJsonChunk) return bad(at, "the first chunk is not JSON");
    if (number == 0) {
      container.text = text_of(chunk->data);
    } else if (auto added = add_chunk(*chunk, number, at, container); !added) {
      return tl::unexpected(added.error());
    }
    at = chunk->end;
  }
  return container;
}

}  // namespace dapple::gltf
