#include "import/gltf/buffers.h"

#include <fmt/format.h>

#include "import/gltf/meshopt.h"
#include "import/gltf/uri.h"

namespace dapple::gltf {
namespace {

constexpr std::string_view kMeshopt = "EXT_meshopt_compression";

std::string buffer_pointer(std::size_t index) { return fmt::format("/buffers/{}", index); }

std::span<const std::byte> bytes_of(const std::vector<std::uint8_t>& data) {
  return std::as_bytes(std::span(data));
}

}  // namespace

Expected<Buffers::Buffer> Buffers::load_buffer(std::size_t index) const {
  const Document& document = context_->document;
  const JsonValue& json = document["buffers"][index];
  const std::string pointer = buffer_pointer(index);
  Buffer buffer;
  if (!json.has("uri") && (index > 0 || !document.bin())) {
    // Allowed where nothing reads it: views into it may be compressed elsewhere.
    if (!json["extensions"].has(kMeshopt)) {
      context_->warn(pointer, "it has neither a uri nor the file a BIN chunk for it");
    }
    buffer.is_missing = true;
    return buffer;
  }
  if (!json.has("uri")) {
    buffer.bytes = *document.bin();
  } else if (is_data_uri(json["uri"].text())) {
    auto uri = decode_data_uri(json["uri"].text());
    if (!uri) return document.error(pointer + "/uri", uri.error().message);
    if (uri->media_type != "application/octet-stream" &&
        uri->media_type != "application/gltf-buffer") {
      context_->warn(pointer + "/uri",
                     fmt::format("\"{:.60}\" is not a type of glTF's buffers", uri->media_type));
    }
    buffer.data = std::move(uri->bytes);
    buffer.bytes = bytes_of(buffer.data);
  } else {
    const auto name = file_of_uri(json["uri"].text());
    if (!name) return document.error(pointer + "/uri", name.error().message);
    auto file = document.folder().open(*name);
    if (!file) {
      return fail(file.error().code, document.place(pointer), to_string(file.error()));
    }
    buffer.file = std::move(*file);
    buffer.bytes = buffer.file.bytes();
  }
  const std::uint64_t length = json["byteLength"].count().value_or(0);
  if (buffer.bytes.size() < length) {
    return document.error(pointer, fmt::format("it has {} of the {} bytes that byteLength says",
                                               buffer.bytes.size(), length));
  }
  buffer.bytes = buffer.bytes.first(length);
  return buffer;
}

Expected<Buffers> Buffers::load(const Context& context) {
  Buffers buffers(context);
  const std::size_t count = context.document["buffers"].size();
  for (std::size_t i = 0; i < count; ++i) {
    auto buffer = buffers.load_buffer(i);
    if (!buffer) {
      if (auto status = context.tolerate(buffer.error()); !status) {
        return tl::unexpected(status.error());
      }
      buffer = Buffer();
      buffer->is_missing = true;
    }
    buffers.buffers_.push_back(std::move(*buffer));
  }
  return buffers;
}

Expected<std::span<const std::byte>> Buffers::slice(const JsonValue& view,
                                                    const std::string& pointer) const {
  const Document& document = context_->document;
  const auto index = view["buffer"].index();
  if (!index || *index >= buffers_.size()) {
    return document.error(pointer + "/buffer", "the buffer does not exist");
  }
  const Buffer& buffer = buffers_[*index];
  if (buffer.is_missing) return document.error(buffer_pointer(*index), "the buffer has no data");
  const auto offset = view.has("byteOffset") ? view["byteOffset"].count() : 0;
  const auto length = view["byteLength"].count();
  if (!offset || !length || *offset > buffer.bytes.size() ||
      *length > buffer.bytes.size() - *offset) {
    return document.error(pointer, fmt::format("it does not fit into the {} bytes of buffer {}",
                                               buffer.bytes.size(), *index));
  }
  return buffer.bytes.subspan(*offset, *length);
}

Expected<std::span<const std::byte>> Buffers::unpacked(std::uint32_t index,
                                                       const JsonValue& packed) {
  const auto found = unpacked_.find(index);
  if (found != unpacked_.end()) return std::span<const std::byte>(found->second);
  const std::string pointer = fmt::format("/bufferViews/{}/extensions/{}", index, kMeshopt);
  const auto bytes = slice(packed, pointer);
  if (!bytes) return bytes;
  auto data = unpack_meshopt(packed, *bytes, context_->builder.budget());
  if (!data) return context_->document.error(pointer, data.error().message);
  return std::span<const std::byte>(unpacked_[index] = std::move(*data));
}

Expected<std::span<const std::byte>> Buffers::view(std::uint32_t index) {
  const std::string pointer = fmt::format("/bufferViews/{}", index);
  const JsonValue& view = context_->document["bufferViews"][index];
  if (view.is_null()) return context_->document.error(pointer, "the buffer view does not exist");
  const JsonValue& packed = view["extensions"][kMeshopt];
  return packed.is_object() ? unpacked(index, packed) : slice(view, pointer);
}

}  // namespace dapple::gltf
