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
  // Most sizes are powers of two, for which a mask does what a slow division would.
  std::int32_t k = (period & (period - 1)) == 0 ? i & (period - 1) : i % period;
  if (k < 0) k += period;
  return k < n ? k : 2 * n - 1 - k;
}

// Keeps coordinates where texels can be counted; what is not a number becomes 0.
float bounded(float x) { return x > -1e6f ? std::min(x, 1e6f) : x <= -1e6f ? -1e6f : 0.0f; }

Float4 lerp(Float4 a, Float4 b, float t) { return Float4::all(1.0f - t) * a + Float4::all(t) * b; }

Vec4f numbers_of(Float4 f) {
  Vec4f v;
  f.store(&v.x);
  return v;
}

Float4 sample_level(const MipLevel& level, const Texture& texture, Vec2f uv) {
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
    if (nearest) return read.four(level.texels, row0 + column0);
    const std::size_t row1 = row(j + 1), column1 = column(i + 1);
    const float fx = x - static_cast<float>(i), fy = y - static_cast<float>(j);
    const auto at = [&](std::size_t index) { return read.four(level.texels, index); };
    return lerp(lerp(at(row0 + column0), at(row0 + column1), fx),
                lerp(at(row1 + column0), at(row1 + column1), fx), fy);
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
    return numbers_of(sample_level(levels[0], texture, uv));
  }
  const float level =
      fast_log2(std::max(footprint * scale_of(slot), 1e-30f)) + pyramid->log2_size + kLevelBias;
  if (!(level > 0.0f)) return numbers_of(sample_level(levels[0], texture, uv));
  const auto last = static_cast<float>(pyramid->level_count - 1);
  if (level >= last) {
    return numbers_of(sample_level(levels[pyramid->level_count - 1], texture, uv));
  }
  const auto finer = static_cast<std::size_t>(level);
  return numbers_of(lerp(sample_level(levels[finer], texture, uv),
                         sample_level(levels[finer + 1], texture, uv),
                         level - static_cast<float>(finer)));
}

bool TextureSet::is_black(const TextureSlot& slot, MapUse use,
                          const std::array<Vec2f, 3>& corners) const {
  const Pyramid* pyramid = pyramid_of(slot, use);
  if (pyramid == nullptr) return false;
  const Texture& texture = textures_[static_cast<std::size_t>(slot.texture)];
  Vec2f lo = moved(slot, corners[0]), hi = lo;
  for (const Vec2f corner : {moved(slot, corners[1]), moved(slot, corners[2])}) {
    lo = {std::min(lo.x, corner.x), std::min(lo.y, corner.y)};
    hi = {std::max(hi.x, corner.x), std::max(hi.y, corner.y)};
  }
  // The finest level at which there are few texels to look at.
  constexpr float kMostTexels = 8;
  const MipLevel* level = levels_.data() + pyramid->first_level;
  for (std::uint32_t i = 1; i < pyramid->level_count; ++i, ++level) {
    const float columns = (hi.x - lo.x) * static_cast<float>(level->width);
    const float rows = (hi.y - lo.y) * static_cast<float>(level->height);
    if (std::max(columns, rows) <= kMostTexels) break;
  }
  // With those that are interpolated with.
  const auto first = [](float x, std::int32_t n) {
    return floor_to_int(x * static_cast<float>(n) - 0.5f);
  };
  const std::int32_t i0 = first(lo.x, level->width), j0 = first(lo.y, level->height);
  const std::int32_t columns = std::min(first(hi.x, level->width) + 2 - i0, 2 * level->width);
  const std::int32_t rows = std::min(first(hi.y, level->height) + 2 - j0, 2 * level->height);
  return with_reader(level->coding, [&](const auto& read) {
    for (std::int32_t j = j0; j < j0 + rows; ++j) {
      const auto row = static_cast<std::size_t>(wrapped(j, level->height, texture.wrap_v)) *
                       static_cast<std::size_t>(level->width);
      for (std::int32_t i = i0; i < i0 + columns; ++i) {
        const auto column = static_cast<std::size_t>(wrapped(i, level->width, texture.wrap_u));
        const Vec4f t = read(level->texels, row + column);
        if (t.x > 0 || t.y > 0 || t.z > 0) return false;
      }
    }
    return true;
  });
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
