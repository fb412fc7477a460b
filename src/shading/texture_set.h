// Textures ready for lookups.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/layered_material.h"
#include "scene/scene_view.h"
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

  // The mean over the whole image.
  Vec4f mean(const TextureSlot& slot, MapUse use) const;

  // Level 0 of an image at integer coordinates, which must be inside. `colour` as is_colour_map().
  Vec4f texel(ImageId image, bool colour, std::uint32_t x, std::uint32_t y) const;

  // Bytes of the mip levels.
  std::size_t memory_bytes() const;

 private:
  struct Level {
    const std::uint8_t* texels = nullptr;
    std::int32_t width = 0, height = 0;
  };
  // The levels of one image for one kind of use.
  struct Pyramid {
    TexelFormat format = TexelFormat::rgba8;
    std::uint32_t first_level = 0, level_count = 0;
    float log2_size = 0;  // of the square root of the number of texels
    Vec4f mean{1, 1, 1, 1};
  };
  static constexpr std::uint32_t kNoPyramid = 0xffffffffu;

  void add_pyramid(std::size_t image, bool colour);
  void build_levels(Pyramid& pyramid, bool colour);
  const Pyramid* pyramid_of(const TextureSlot& slot, MapUse use) const;
  Vec4f fetch(TexelFormat format, bool colour, const Level& level, std::int32_t x,
              std::int32_t y) const;
  Vec4f sample_level(const Texture& texture, const Pyramid& pyramid, bool colour,
                     std::uint32_t level, Vec2f uv) const;

  std::span<const Texture> textures_;
  std::span<const TextureImage> images_;
  std::span<const std::uint8_t> texels_;
  std::vector<std::array<std::uint32_t, 2>> pyramid_ids_;  // of an image: as data, as colour
  std::vector<Pyramid> pyramids_;
  std::vector<Level> levels_;
  std::vector<std::vector<std::uint8_t>> storage_;
};

}  // namespace dapple
