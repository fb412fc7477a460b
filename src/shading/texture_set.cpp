#include "shading/texture_set.h"

#include <algorithm>

#include "math/fast_functions.h"

namespace dapple {
namespace {

// Samples of a pixel lie all over it and blur already; a finer level than the pixel's own keeps
// what they could show.
constexpr float kLevelBias = -1.0f;

std::int32_t wrapped(std::int32_t i, std::int32_t n, Wrap wrap) {
  if (i >= 0 && i < n) return i;
  if (wrap == Wrap::clamp_to_edge) return i < 0 ? 0 : n - 1;
  const std::int32_t period = wrap == Wrap::repeat ? n : 2 * n;
  std::int32_t k = i % period;
  if (k < 0) k += period;
  return k < n ? k : 2 * n - 1 - k;
}

// Keeps coordinates where texels can be counted; what is not a number becomes 0.
float bounded(float x) { return x > -1e6f ? std::min(x, 1e6f) : x <= -1e6f ? -1e6f : 0.0f; }

Vec4f lerp(Vec4f a, Vec4f b, float t) { return (1.0f - t) * a + t * b; }

Vec4f sample_level(const MipLevel& level, const Texture& texture, Vec2f uv) {
  const auto width = static_cast<float>(level.width), height = static_cast<float>(level.height);
  const bool nearest = texture.filter == Filter::nearest;
  const float offset = nearest ? 0.0f : 0.5f;
  const float x = uv.x * width - offset, y = uv.y * height - offset;
  const std::int32_t i = floor_to_int(x), j = floor_to_int(y);
  const auto column = [&](std::int32_t k) {
    return static_cast<std::size_t>(wrapped(k, level.width, texture.wrap_u));
  };
  const auto row = [&](std::int32_t k) {
    return static_cast<std::size_t>(wrapped(k, level.height, texture.wrap_v)) *
           static_cast<std::size_t>(level.width);
  };
  return with_reader(level.coding, [&](const auto& read) {
    const std::size_t row0 = row(j), column0 = column(i);
    if (nearest) return read(level.texels, row0 + column0);
    const std::size_t row1 = row(j + 1), column1 = column(i + 1);
    const float fx = x - static_cast<float>(i), fy = y - static_cast<float>(j);
    return lerp(lerp(read(level.texels, row0 + column0), read(level.texels, row0 + column1), fx),
                lerp(read(level.texels, row1 + column0), read(level.texels, row1 + column1), fx),
                fy);
  });
}

Vec2f moved(const TextureSlot& slot, Vec2f p) {
  const auto& m = slot.to_uv;
  return {bounded(m[0][0] * p.x + m[0][1] * p.y + m[0][2]),
          bounded(m[1][0] * p.x + m[1][1] * p.y + m[1][2])};
}

// How much longer lengths become by the slot's map.
float scale_of(const TextureSlot& slot) {
  const auto& m = slot.to_uv;
  return std::sqrt(std::fabs(m[0][0] * m[1][1] - m[0][1] * m[1][0]));
}

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

MipLevel TextureSet::whole_image(std::size_t image, bool colour) const {
  const TextureImage& source = images_[image];
  return {texels_.data() + source.offset, coding_of(source.format, colour),
          static_cast<std::int32_t>(source.width), static_cast<std::int32_t>(source.height)};
}

void TextureSet::add_pyramid(std::size_t image, bool colour) {
  if (pyramid_ids_[image][colour] != kNoPyramid) return;
  pyramid_ids_[image][colour] = static_cast<std::uint32_t>(pyramids_.size());
  MipLevel level = whole_image(image, colour);
  Pyramid pyramid{
      static_cast<std::uint32_t>(levels_.size()), 1,
      0.5f * fast_log2(static_cast<float>(level.width) * static_cast<float>(level.height))};
  levels_.push_back(level);
  while (level.width > 1 || level.height > 1) {
    OwnedMipLevel next = next_mip_level(level);
    level = next.level;
    storage_.push_back(std::move(next.storage));
    levels_.push_back(level);
    ++pyramid.level_count;
  }
  pyramids_.push_back(pyramid);
}

const TextureSet::Pyramid* TextureSet::pyramid_of(const TextureSlot& slot, MapUse use) const {
  if (slot.texture == kNoTexture) return nullptr;
  const auto image = textures_[static_cast<std::size_t>(slot.texture)].image;
  const std::uint32_t id = pyramid_ids_[static_cast<std::size_t>(image)][is_colour_map(use)];
  return id == kNoPyramid ? nullptr : &pyramids_[id];
}

Vec4f TextureSet::lookup(const TextureSlot& slot, MapUse use, const SurfaceInteraction& at) const {
  const Pyramid* pyramid = pyramid_of(slot, use);
  if (pyramid == nullptr) return {1, 1, 1, 1};
  const Texture& texture = textures_[static_cast<std::size_t>(slot.texture)];
  const Vec2f uv = moved(slot, at.uvs[slot.uv_set]);
  const MipLevel* levels = levels_.data() + pyramid->first_level;
  const float footprint = at.cone_width * at.uv_per_length[slot.uv_set];
  if (!(footprint > 1e-12f) || texture.filter == Filter::nearest) {
    return sample_level(levels[0], texture, uv);
  }
  const float level =
      fast_log2(std::max(footprint * scale_of(slot), 1e-30f)) + pyramid->log2_size + kLevelBias;
  if (!(level > 0.0f)) return sample_level(levels[0], texture, uv);
  const auto last = static_cast<float>(pyramid->level_count - 1);
  if (level >= last) return sample_level(levels[pyramid->level_count - 1], texture, uv);
  const auto finer = static_cast<std::size_t>(level);
  return lerp(sample_level(levels[finer], texture, uv),
              sample_level(levels[finer + 1], texture, uv), level - static_cast<float>(finer));
}

Vec4f TextureSet::mean(const TextureSlot& slot, MapUse use) const {
  const Pyramid* pyramid = pyramid_of(slot, use);
  if (pyramid == nullptr) return {1, 1, 1, 1};
  const MipLevel& level = levels_[pyramid->first_level + pyramid->level_count - 1];
  return with_reader(level.coding, [&](const auto& read) { return read(level.texels, 0); });
}

Vec4f TextureSet::texel(ImageId image, bool colour, std::uint32_t x, std::uint32_t y) const {
  const MipLevel level = whole_image(static_cast<std::size_t>(image), colour);
  const std::size_t index = std::size_t{y} * static_cast<std::size_t>(level.width) + x;
  return with_reader(level.coding, [&](const auto& read) { return read(level.texels, index); });
}

std::size_t TextureSet::memory_bytes() const {
  std::size_t total = 0;
  for (const auto& level : storage_) total += level.size();
  return total;
}

}  // namespace dapple
