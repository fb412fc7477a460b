#include "import/gltf/textures.h"

#include <fmt/format.h>

#include <deque>
#include <numbers>
#include <set>

#include "import/gltf/uri.h"
#include "import/image_loader.h"
#include "math/functions.h"

namespace dapple::gltf {
namespace {

constexpr std::uint64_t kNearest = 9728;
constexpr std::uint64_t kClampToEdge = 33071;
constexpr std::uint64_t kMirroredRepeat = 33648;

Wrap wrap_of(const JsonValue& mode) {
  const auto number = mode.count();
  if (number == kClampToEdge) return Wrap::clamp_to_edge;
  return number == kMirroredRepeat ? Wrap::mirrored_repeat : Wrap::repeat;
}

// Every textureInfo of a material, extensions included, is an object under a key "...Texture".
void collect_textures(const JsonValue& value, std::set<std::uint32_t>& textures) {
  for (const JsonMember& member : value.members()) {
    const auto index = member.value["index"].index();
    if (member.key.ends_with("Texture") && index) textures.insert(*index);
    collect_textures(member.value, textures);
  }
}

// The picture of a texture. What this program can decode goes first.
std::optional<std::uint32_t> source_of(const JsonValue& texture) {
  const JsonValue& webp = texture["extensions"]["EXT_texture_webp"]["source"];
  return webp.is_number() ? webp.index() : texture["source"].index();
}

// The bytes of pictures, wherever they come from, kept until all are decoded.
class Pictures {
 public:
  Pictures(const Context& context, Buffers& buffers) : context_(context), buffers_(buffers) {}

  Expected<std::span<const std::byte>> bytes(std::uint32_t image) {
    const Document& document = context_.document;
    const JsonValue& json = document["images"][image];
    const std::string pointer = fmt::format("/images/{}", image);
    if (json.is_null()) return document.error(pointer, "the image does not exist");
    if (json.has("bufferView")) {
      const auto view = json["bufferView"].index();
      if (!view) return document.error(pointer + "/bufferView", "is not the number of a view");
      return buffers_.view(*view);
    }
    const std::string& uri = json["uri"].text();
    if (is_data_uri(uri)) {
      auto data = decode_data_uri(uri);
      if (!data) return document.error(pointer + "/uri", data.error().message);
      return std::as_bytes(std::span(data_.emplace_back(std::move(data->bytes))));
    }
    const auto name = file_of_uri(uri);
    if (!name) return document.error(pointer + "/uri", name.error().message);
    auto file = document.folder().open(*name);
    if (!file) return fail(file.error().code, document.place(pointer), to_string(file.error()));
    return files_.emplace_back(std::move(*file)).bytes();
  }

 private:
  const Context& context_;
  Buffers& buffers_;
  std::deque<MappedFile> files_;
  std::deque<std::vector<std::uint8_t>> data_;
};

struct Wanted {
  std::uint32_t texture = 0;
  std::optional<std::size_t> picture;  // its place among those to decode
};

// rotation * scale after which the offset is added (KHR_texture_transform); v points down, so that
// a positive angle turns the other way round than in the usual matrix.
void set_transform(const JsonValue& transform, TextureSlot& slot) {
  const double turns = transform["rotation"].number_or(0) / (2 * std::numbers::pi);
  const auto [sin, cos] = sin_cos_turns(turns);
  const double scale_x = transform["scale"][0].number_or(1);
  const double scale_y = transform["scale"][1].number_or(1);
  const double rows[2][3] = {{cos * scale_x, sin * scale_y, transform["offset"][0].number_or(0)},
                             {-sin * scale_x, cos * scale_y, transform["offset"][1].number_or(0)}};
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 3; ++j) slot.to_uv[i][j] = static_cast<float>(rows[i][j]);
  }
}

}  // namespace

Expected<Textures> Textures::load(const Context& context, Buffers& buffers) {
  const Document& document = context.document;
  std::set<std::uint32_t> used;
  for (const JsonValue& material : document["materials"].items()) collect_textures(material, used);

  // Fetch the bytes.
  Pictures pictures(context, buffers);
  std::vector<EncodedImage> encoded;
  std::map<std::uint32_t, std::size_t> picture_of_image;
  std::vector<Wanted> wanted;
  for (const std::uint32_t texture : used) {
    const JsonValue& json = document["textures"][texture];
    if (json.is_null()) continue;
    Wanted want{texture, {}};
    const auto image = source_of(json);
    const std::string pointer = fmt::format("/textures/{}", texture);
    if (json["extensions"].has("KHR_texture_basisu") && image) {
      context.warn(pointer, "KHR_texture_basisu cannot be decoded: its fallback image is used");
    }
    if (!image) {
      const bool basisu = json["extensions"].has("KHR_texture_basisu");
      const auto error =
          document.error(pointer, basisu ? "it has only a KTX2 image, which cannot be decoded"
                                         : "it has no image");
      if (basisu) {
        if (auto ok = context.tolerate(error.value()); !ok) return tl::unexpected(ok.error());
      } else {
        context.log.warn(to_string(error.value()));
      }
    } else if (const auto known = picture_of_image.find(*image); known != picture_of_image.end()) {
      want.picture = known->second;
    } else {
      const auto bytes = pictures.bytes(*image);
      if (bytes) {
        want.picture = encoded.size();
        picture_of_image[*image] = encoded.size();
        encoded.push_back({*bytes, document.place(fmt::format("/images/{}", *image))});
      } else if (auto ok = context.tolerate(bytes.error()); !ok) {
        return tl::unexpected(ok.error());
      }
    }
    wanted.push_back(want);
  }

  const auto ids = load_images(encoded, context.options.keep_going, context.builder, context.log);
  if (!ids) return tl::unexpected(ids.error());
  Textures textures(context);
  textures.textures_.resize(document["textures"].size());
  for (const Wanted& want : wanted) {
    const ImageId image = want.picture ? (*ids)[*want.picture] : kNoImage;
    if (image == kNoImage) {
      textures.textures_[want.texture] = context.builder.magenta_texture();
      continue;
    }
    const auto sampler = document["textures"][want.texture]["sampler"].index();
    const JsonValue& json = document["samplers"][sampler.value_or(0xffffffffu)];
    const bool nearest = json["magFilter"].count() == kNearest;
    textures.textures_[want.texture] =
        context.builder.add_texture({image, wrap_of(json["wrapS"]), wrap_of(json["wrapT"]),
                                     nearest ? Filter::nearest : Filter::linear});
  }
  return textures;
}

Expected<TextureSlot> Textures::slot(const JsonValue& info, const std::string& pointer) const {
  TextureSlot slot;
  if (!info.is_object()) return slot;
  const auto index = info["index"].index();
  if (!index || *index >= textures_.size() || !textures_[*index]) {
    return context_->document.error(pointer + "/index", "the texture does not exist");
  }
  const JsonValue& transform = info["extensions"]["KHR_texture_transform"];
  const JsonValue& set = transform.has("texCoord") ? transform["texCoord"] : info["texCoord"];
  slot.uv_set = set.index().value_or(0);
  if (slot.uv_set >= kUvSetCount) {
    context_->warn(
        pointer, fmt::format("TEXCOORD_{} is not supported: the texture is left out", slot.uv_set));
    return TextureSlot();
  }
  slot.texture = *textures_[*index];
  if (transform.is_object()) set_transform(transform, slot);
  return slot;
}

}  // namespace dapple::gltf
