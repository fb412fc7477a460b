// Textures ready for lookups.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/layered_material.h"
#include "scene/scene_view.h"
#include "shading/mip_levels.h"
#include "shading/surface_interaction.h"

namespace dapple {

// Reads the scene's texels where they lie, so the arrays behind the view must outlive this. Mip
// levels are made at construction, in linear light, for the images that materials use.
class TextureSet {
 public:
  TextureSet() = default;
  explicit TextureSet(const SceneView& scene);

  // The linear value of the map at a point, filtered over the point's ray cone: by the texture's
  // own filter where magnified, between mip levels where minified. White without a texture.
  Vec4f lookup(const TextureSlot& slot, MapUse use, const SurfaceInteraction& at) const;

  // The mean over the whole image, to the precision of its texels.
  Vec4f mean(const TextureSlot& slot, MapUse use) const;

  // Whether the map is black all over a triangle of texture coordinates, as far as the levels tell
  // that are coarse enough to be read quickly.
  bool is_black(const TextureSlot& slot, MapUse use, const std::array<Vec2f, 3>& corners) const;

  // Level 0 of an image at integer coordinates, which must be inside. `colour` as is_colour_map().
  Vec4f texel(ImageId image, bool colour, std::uint32_t x, std::uint32_t y) const;

  // Bytes of the mip levels.
  std::size_t memory_bytes() const;

 private:
  // The levels of one image for one kind of use, the whole image first.
  struct Pyramid {
    std::uint32_t first_level = 0, level_count = 0;
    float log2_size = 0;  // of the square root of the number of texels
  };
  static constexpr std::uint32_t kNoPyramid = 0xffffffffu;

  MipLevel whole_image(std::size_t image, bool colour) const;
  void add_pyramid(std::size_t image, bool colour);
  const Pyramid* pyramid_of(const TextureSlot& slot, MapUse use) const;

  std::span<const Texture> textures_;
  std::span<const TextureImage> images_;
  std::span<const std::uint8_t> texels_;
  std::vector<std::array<std::uint32_t, 2>> pyramid_ids_;  // of an image: as data, as colour
  std::vector<Pyramid> pyramids_;
  std::vector<MipLevel> levels_;
  std::vector<std::vector<std::uint8_t>> storage_;
};

}  // namespace dapple
