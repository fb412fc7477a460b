#include "scene/validate_looks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/layered_fields.h"
#include "scene/validate.h"
#include "util/utf8.h"

namespace dapple {
namespace {

// False for NaN, and for infinity unless `high` is.
bool is_within(float x, float low, float high) { return x >= low && x <= high; }

bool is_within(const Vec3f& v, float low, float high) {
  return is_within(v.x, low, high) && is_within(v.y, low, high) && is_within(v.z, low, high);
}

bool is_amount(const Vec3f& v) { return is_within(v, 0, std::numeric_limits<float>::max()); }

bool is_finite_slot(const TextureSlot& slot) {
  return std::all_of(&slot.to_uv[0][0], &slot.to_uv[0][0] + 6,
                     [](float x) { return std::isfinite(x); });
}

std::string reason_against(const TextureSlot& slot, std::size_t texture_count) {
  if (slot.texture != kNoTexture && static_cast<std::size_t>(slot.texture) >= texture_count) {
    return "texture does not exist";
  }
  if (slot.uv_set >= kUvSetCount) return "set of texture coordinates does not exist";
  if (!is_finite_slot(slot)) return "transform of texture coordinates is not finite";
  return {};
}

bool image_exists(ImageId image, std::size_t image_count) {
  return static_cast<std::size_t>(image) < image_count;
}

}  // namespace

std::string reason_against(const LayeredMaterial& m, std::size_t texture_count) {
  if (static_cast<std::uint32_t>(m.model) > 1) return "its model is not known";
  if (static_cast<std::uint32_t>(m.alpha_mode) > 2) return "its alpha mode is not known";
  if (m.unlit > 1 || m.double_sided > 1) return "a switch is neither 0 nor 1";
  for (const LayeredNumber& number : layered_numbers()) {
    if (is_within(m.*number.member, number.low, number.high)) continue;
    return fmt::format("its {} is out of range", number.name);
  }
  for (const LayeredColour& colour : layered_colours()) {
    if (is_within(m.*colour.member, 0, colour.high)) continue;
    return fmt::format("its {} is out of range", colour.name);
  }
  for (std::size_t i = 0; i < kMapUseCount; ++i) {
    const std::string reason = reason_against(m.maps[i], texture_count);
    if (reason.empty()) continue;
    return fmt::format("its {} map: the {}", map_name(static_cast<MapUse>(i)), reason);
  }
  return {};
}

std::string reason_against(const Light& light) {
  constexpr float kHalfTurn = 3.1415927f;
  if (light.kind > LightKind::directional) return "its kind is not known";
  if (!(max_abs_component(light.position) <= static_cast<float>(kMaxCoordinate)) ||
      !is_finite(light.position)) {
    return fmt::format("its position is not finite or beyond {:g}", kMaxCoordinate);
  }
  if (!(std::fabs(dot(light.direction, light.direction) - 1) <= kUnitTolerance)) {
    return "its direction is not of length 1";
  }
  if (!is_amount(light.intensity)) return "its intensity is negative or not finite";
  if (!is_within(light.outer_angle, 0, kHalfTurn) ||
      !is_within(light.inner_angle, 0, light.outer_angle)) {
    return "its angles are not 0 <= inner <= outer <= pi";
  }
  return {};
}

std::string reason_against(const Environment& e, std::size_t image_count) {
  if (e.kind > EnvironmentKind::studio) return "its kind is not known";
  const bool needs_image = e.kind == EnvironmentKind::image;
  if ((needs_image || e.image != kNoImage) && !image_exists(e.image, image_count)) {
    return "its image does not exist";
  }
  if (!is_amount(e.colour)) return "its colour is negative or not finite";
  if (!std::isfinite(e.rotation)) return "its rotation is not finite";
  return {};
}

std::string reason_against(const NamedCamera& camera) {
  const auto end = std::find(camera.name.begin(), camera.name.end(), '\0');
  if (end == camera.name.end() ||
      !std::all_of(end, camera.name.end(), [](char c) { return c == '\0'; })) {
    return "its name does not end, or something follows it";
  }
  if (!is_utf8({camera.name.data(), static_cast<std::size_t>(end - camera.name.begin())})) {
    return "its name is not UTF-8";
  }
  const Status status = validate(camera.camera);
  return status ? std::string() : status.error().message;
}

bool is_valid(const Texture& texture, std::size_t image_count) {
  return image_exists(texture.image, image_count) && texture.wrap_u <= Wrap::clamp_to_edge &&
         texture.wrap_v <= Wrap::clamp_to_edge && texture.filter <= Filter::nearest;
}

bool image_is_valid(std::span<const TextureImage> images, std::size_t index,
                    std::size_t texel_bytes) {
  constexpr std::uint64_t kAlignment = 16;
  const TextureImage& image = images[index];
  const auto is_side = [](std::uint32_t side) { return side > 0 && side <= kMaxImageSide; };
  if (image.format > TexelFormat::rgb32f || !is_side(image.width) || !is_side(image.height) ||
      image.reserved != 0) {
    return false;
  }
  // Sizes that are broken themselves may add up to anything, but not overflow what is read.
  const std::uint64_t end_before =
      index == 0 ? 0 : images[index - 1].offset + images[index - 1].bytes();
  if (image.offset != (end_before + kAlignment - 1) / kAlignment * kAlignment) return false;
  if (image.offset > texel_bytes || image.bytes() > texel_bytes - image.offset) return false;
  return index + 1 < images.size() || texel_bytes - image.offset - image.bytes() < kAlignment;
}

}  // namespace dapple
