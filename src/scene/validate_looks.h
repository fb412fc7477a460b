// What must hold of materials, textures, lights and cameras. Reasons are empty when all is well.
#pragma once

#include <span>
#include <string>

#include "scene/scene_view.h"

namespace dapple {

// A side of an image at most.
inline constexpr std::uint32_t kMaxImageSide = 1u << 16;

[[nodiscard]] std::string reason_against(const LayeredMaterial& material,
                                         std::size_t texture_count);
[[nodiscard]] std::string reason_against(const Light& light);
[[nodiscard]] std::string reason_against(const Environment& environment, std::size_t image_count);
[[nodiscard]] std::string reason_against(const NamedCamera& camera);

[[nodiscard]] bool is_valid(const Texture& texture, std::size_t image_count);

// Images lie in the texels in their order, each at the first multiple of 16 after the one before,
// and less than 16 bytes after the last: so nothing is there twice, and what is made of the images
// of a file cannot be much larger than the file.
[[nodiscard]] bool image_is_valid(std::span<const TextureImage> images, std::size_t index,
                                  std::size_t texel_bytes);

}  // namespace dapple
