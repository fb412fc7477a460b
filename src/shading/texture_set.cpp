#include "shading/texture_set.h"

#include <cstring>

#include "image/transfer.h"
#include "math/fast_functions.h"

namespace dapple {
namespace {

// Linear values of all 8-bit and 16-bit codes, as data and as sRGB colour.
struct DecodeTables {
  std::vector<float> srgb8 = decode_table(255, Transfer::srgb);
  std::vector<float> srgb16 = decode_table(65535, Transfer::srgb);
};
const DecodeTables& tables() {
  static const DecodeTables instance;
  return instance;
}

std::int32_t wrapped(std::int32_t i, std::int32_t n, Wrap wrap) {
  if (i >= 0 && i < n) return i;
  if (wrap == Wrap::clamp_to_edge) return i < 0 ? 0 : n - 1;
  const std::int32_t period = wrap == Wrap::repeat ? n : 2 * n;
  std::int32_t k = i % period;
  if (k < 0) k += period;
  return k < n ? k : 2 * n - 1 - k;
}

Vec4f lerp(Vec4f a, Vec4f b, float t) { return (1.0f - t) * a + t * b; }

}  // namespace

TextureSet::TextureSet(const SceneView& scene)
    : textures_(scene.textures),
      images_(scene.images),
      texels_(scene.texels),
      pyramid_ids_(scene.images.size(), {kNoPyramid, kNoPyramid}) {
  for (const LayeredMaterial& material : scene.layered_materials) {
    for (std::size_t i = 0; i < kMapUseCount; ++i) {
      const TextureId id = material.maps[i].texture;
      if (id == kNoTexture) continue;
      const auto image = static_cast<std::size_t>(textures_[static_cast<std::size_t>(id)].image);
      add_pyramid(image, is_colour_map(static_cast<MapUse>(i)));
    }
  }
}

void TextureSet::add_pyramid(std::size_t image, bool colour) {
  if (pyramid_ids_[image][colour] != kNoPyramid) return;
  pyramid_ids_[image][colour] = static_cast<std::uint32_t>(pyramids_.size());
  const TextureImage& source = images_[image];
  Pyramid pyramid{.format = source.format,
                  .first_level = static_cast<std::uint32_t>(levels_.size()),
                  .level_count = 1};
  levels_.push_back({texels_.data() + source.offset, static_cast<std::int32_t>(source.width),
                     static_cast<std::int32_t>(source.height)});
  pyramid.log2_size =
      0.5f * fast_log2(static_cast<float>(source.width) * static_cast<float>(source.height));
  build_levels(pyramid, colour);
  pyramids_.push_back(pyramid);
}

void TextureSet::build_levels(Pyramid& pyramid, bool colour) {
  const Level level = levels_[pyramid.first_level];
  double sum[4] = {};
  for (std::int32_t y = 0; y < level.height; ++y) {
    for (std::int32_t x = 0; x < level.width; ++x) {
      const Vec4f v = fetch(pyramid.format, colour, level, x, y);
      sum[0] += v.x, sum[1] += v.y, sum[2] += v.z, sum[3] += v.w;
    }
  }
  const double n = static_cast<double>(level.width) * level.height;
  pyramid.mean = {static_cast<float>(sum[0] / n), static_cast<float>(sum[1] / n),
                  static_cast<float>(sum[2] / n), static_cast<float>(sum[3] / n)};
}

const TextureSet::Pyramid* TextureSet::pyramid_of(const TextureSlot& slot, MapUse use) const {
  if (slot.texture == kNoTexture) return nullptr;
  const auto image = textures_[static_cast<std::size_t>(slot.texture)].image;
  const std::uint32_t id = pyramid_ids_[static_cast<std::size_t>(image)][is_colour_map(use)];
  return id == kNoPyramid ? nullptr : &pyramids_[id];
}

Vec4f TextureSet::fetch(TexelFormat format, bool colour, const Level& level, std::int32_t x,
                        std::int32_t y) const {
  const std::size_t index = static_cast<std::size_t>(y) * static_cast<std::size_t>(level.width) +
                            static_cast<std::size_t>(x);
  if (format == TexelFormat::rgba8) {
    const std::uint8_t* t = level.texels + 4 * index;
    constexpr float kScale = 1.0f / 255;
    if (!colour) return {t[0] * kScale, t[1] * kScale, t[2] * kScale, t[3] * kScale};
    const float* srgb = tables().srgb8.data();
    return {srgb[t[0]], srgb[t[1]], srgb[t[2]], t[3] * kScale};
  }
  if (format == TexelFormat::rgba16) {
    std::uint16_t t[4];
    std::memcpy(t, level.texels + 8 * index, sizeof(t));
    constexpr float kScale = 1.0f / 65535;
    if (!colour) return {t[0] * kScale, t[1] * kScale, t[2] * kScale, t[3] * kScale};
    const float* srgb = tables().srgb16.data();
    return {srgb[t[0]], srgb[t[1]], srgb[t[2]], t[3] * kScale};
  }
  float t[3];
  std::memcpy(t, level.texels + 12 * index, sizeof(t));
  return {t[0], t[1], t[2], 1.0f};
}

Vec4f TextureSet::sample_level(const Texture& texture, const Pyramid& pyramid, bool colour,
                               std::uint32_t level_index, Vec2f uv) const {
  const Level& level = levels_[pyramid.first_level + level_index];
  const float x = uv.x * static_cast<float>(level.width);
  const float y = uv.y * static_cast<float>(level.height);
  const auto at = [&](std::int32_t i, std::int32_t j) {
    return fetch(pyramid.format, colour, level, wrapped(i, level.width, texture.wrap_u),
                 wrapped(j, level.height, texture.wrap_v));
  };
  if (texture.filter == Filter::nearest) return at(floor_to_int(x), floor_to_int(y));
  const std::int32_t i = floor_to_int(x - 0.5f), j = floor_to_int(y - 0.5f);
  const float fx = x - 0.5f - static_cast<float>(i), fy = y - 0.5f - static_cast<float>(j);
  return lerp(lerp(at(i, j), at(i + 1, j), fx), lerp(at(i, j + 1), at(i + 1, j + 1), fx), fy);
}

Vec4f TextureSet::lookup(const TextureSlot& slot, MapUse use, const SurfaceInteraction& at) const {
  const Pyramid* pyramid = pyramid_of(slot, use);
  if (pyramid == nullptr) return {1, 1, 1, 1};
  const Vec2f p = at.uvs[slot.uv_set];
  const auto& m = slot.to_uv;
  const Vec2f uv{m[0][0] * p.x + m[0][1] * p.y + m[0][2], m[1][0] * p.x + m[1][1] * p.y + m[1][2]};
  const Texture& texture = textures_[static_cast<std::size_t>(slot.texture)];
  return sample_level(texture, *pyramid, is_colour_map(use), 0, uv);
}

Vec4f TextureSet::mean(const TextureSlot& slot, MapUse use) const {
  const Pyramid* pyramid = pyramid_of(slot, use);
  return pyramid == nullptr ? Vec4f{1, 1, 1, 1} : pyramid->mean;
}

Vec4f TextureSet::texel(ImageId image, bool colour, std::uint32_t x, std::uint32_t y) const {
  const TextureImage& source = images_[static_cast<std::size_t>(image)];
  const Level level{texels_.data() + source.offset, static_cast<std::int32_t>(source.width),
                    static_cast<std::int32_t>(source.height)};
  return fetch(source.format, colour, level, static_cast<std::int32_t>(x),
               static_cast<std::int32_t>(y));
}

std::size_t TextureSet::memory_bytes() const {
  std::size_t total = 0;
  for (const auto& level : storage_) total += level.size();
  return total;
}

}  // namespace dapple
