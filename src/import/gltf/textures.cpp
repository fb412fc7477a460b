#include "import/gltf/textures.h"

#include <fmt/format.h>

#include <map>
#include <numbers>
#include <set>

#include "import/gltf/pictures.h"
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

// The textures of a material: every textureInfo, extensions included, is an object under a key
// "...Texture". Occlusion and thickness are for renderers that cannot tell by their rays.
void collect_textures(const JsonValue& value, std::set<std::uint32_t>& textures) {
  for (const JsonMember& member : value.members()) {
    const bool counts = member.key != "occlusionTexture" && member.key != "thicknessTexture" &&
                        member.key != "extras";
    if (!counts) continue;
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

// Textures with the bytes of their pictures, each once.
class Gatherer {
 public:
  Gatherer(const Context& context, Pictures& pictures) : context_(context), pictures_(pictures) {}

  Status add(std::uint32_t texture) {
    const JsonValue& json = context_.document["textures"][texture];
    if (json.is_null()) return {};
    const auto image = source_of(json);
    const std::string pointer = fmt::format("/textures/{}", texture);
    const bool basisu = json["extensions"].has("KHR_texture_basisu");
    if (basisu && image) {
      context_.warn(pointer, "KHR_texture_basisu cannot be decoded: its fallback image is used");
    }
    wanted_.push_back({texture, {}});
    if (!image) return without_image(pointer, basisu);
    images_.insert(*image);
    const auto [known, is_new] = place_of_image_.try_emplace(*image, encoded_.size());
    if (is_new) {
      auto encoded = pictures_.encoded(*image);
      if (!encoded) {
        place_of_image_.erase(known);
        return context_.tolerate(encoded.error());
      }
      encoded_.push_back(std::move(*encoded));
    }
    wanted_.back().picture = known->second;
    return {};
  }

  const std::vector<EncodedImage>& encoded() const { return encoded_; }
  const std::vector<Wanted>& wanted() const { return wanted_; }
  // The numbers of all images that were asked for.
  const std::set<std::uint32_t>& images() const { return images_; }

 private:
  Status without_image(const std::string& pointer, bool basisu) const {
    const auto error = context_.document.error(
        pointer, basisu ? "it has only a KTX2 image, which cannot be decoded" : "it has no image");
    if (basisu) return context_.tolerate(error.value());
    context_.log.warn(to_string(error.value()));
    return {};
  }

  const Context& context_;
  Pictures& pictures_;
  std::vector<EncodedImage> encoded_;
  std::map<std::uint32_t, std::size_t> place_of_image_;  // in encoded_
  std::vector<Wanted> wanted_;
  std::set<std::uint32_t> images_;
};

Texture settings_of(const Document& document, std::uint32_t texture, ImageId image) {
  const auto sampler = document["textures"][texture]["sampler"].index();
  const JsonValue& json = document["samplers"][sampler.value_or(0xffffffffu)];
  const bool nearest = json["magFilter"].count() == kNearest;
  return {image, wrap_of(json["wrapS"]), wrap_of(json["wrapT"]),
          nearest ? Filter::nearest : Filter::linear};
}

}  // namespace

Expected<Textures> Textures::load(const Context& context, Buffers& buffers,
                                  const std::set<std::uint32_t>& materials) {
  const Document& document = context.document;
  std::set<std::uint32_t> used;
  for (const std::uint32_t material : materials) {
    collect_textures(document["materials"][material], used);
  }
  Pictures pictures(context, buffers);
  Gatherer gathered(context, pictures);
  for (const std::uint32_t texture : used) {
    if (auto added = gathered.add(texture); !added) return tl::unexpected(added.error());
  }
  const auto ids =
      load_images(gathered.encoded(), context.options.keep_going, context.builder, context.log);
  if (!ids) return tl::unexpected(ids.error());
  Textures textures(context);
  textures.images_ = gathered.images();
  textures.textures_.resize(document["textures"].size());
  for (const Wanted& want : gathered.wanted()) {
    const ImageId image = want.picture ? (*ids)[*want.picture] : kNoImage;
    textures.textures_[want.texture] =
        image == kNoImage ? context.builder.magenta_texture()
                          : context.builder.add_texture(settings_of(document, want.texture, image));
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
