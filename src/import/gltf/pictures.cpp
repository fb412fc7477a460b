#include "import/gltf/pictures.h"

#include <fmt/format.h>

#include "import/gltf/uri.h"
#include "import/text.h"

namespace dapple::gltf {
namespace {

bool is_image_type(std::string_view type) {
  return type == "image/png" || type == "image/jpeg" || type == "image/webp" ||
         type == "image/ktx2";
}

}  // namespace

std::string_view image_type(std::span<const std::byte> bytes) {
  const std::string_view head = as_text(bytes.first(std::min<std::size_t>(bytes.size(), 12)));
  if (head.starts_with("\x89PNG\r\n\x1a\n")) return "image/png";
  if (head.starts_with("\xff\xd8\xff")) return "image/jpeg";
  if (head.starts_with("RIFF") && head.ends_with("WEBP")) return "image/webp";
  if (head.starts_with("\xabKTX 20\xbb\r\n\x1a\n")) return "image/ktx2";
  return {};
}

Expected<std::span<const std::byte>> Pictures::bytes(const JsonValue& image,
                                                     const std::string& pointer) {
  const Document& document = context_.document;
  if (image.is_null()) return document.error(pointer, "the image does not exist");
  if (image.has("bufferView")) {
    const auto view = image["bufferView"].index();
    if (!view) return document.error(pointer + "/bufferView", "is not the number of a view");
    return buffers_.view(*view);
  }
  const std::string& uri = image["uri"].text();
  if (is_data_uri(uri)) {
    auto data = decode_data_uri(uri);
    if (!data) return document.error(pointer + "/uri", data.error().message);
    if (!is_image_type(data->media_type)) {
      context_.warn(pointer + "/uri",
                    fmt::format("\"{:.60}\" is not a type of glTF's images", data->media_type));
    }
    return std::as_bytes(std::span(data_.emplace_back(std::move(data->bytes))));
  }
  const auto name = file_of_uri(uri);
  if (!name) return document.error(pointer + "/uri", name.error().message);
  auto file = document.folder().open(*name);
  if (!file) return fail(file.error().code, document.place(pointer), to_string(file.error()));
  return files_.emplace_back(std::move(*file)).bytes();
}

Expected<EncodedImage> Pictures::encoded(std::uint32_t number) {
  const JsonValue& image = context_.document["images"][number];
  const std::string pointer = fmt::format("/images/{}", number);
  const auto content = bytes(image, pointer);
  if (!content) return tl::unexpected(content.error());
  const std::string_view type = image_type(*content);
  const std::string& said = image["mimeType"].text();
  if (!type.empty() && !said.empty() && type != said) {
    context_.warn(pointer + "/mimeType", fmt::format("says {:.60}, but it is {}", said, type));
  }
  const std::string& uri = image["uri"].text();
  const std::string name = uri.empty() || is_data_uri(uri) ? "" : fmt::format(" ({:.200})", uri);
  return EncodedImage{*content, context_.document.place(pointer) + name};
}

}  // namespace dapple::gltf
