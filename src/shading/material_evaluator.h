// From a material and a point of a surface to its reflectance, opacity, emission and inside.
#pragma once

#include <array>
#include <vector>

#include "scene/scene_view.h"
#include "shading/bsdf.h"
#include "shading/bsdf_builder.h"
#include "shading/medium.h"
#include "shading/surface_interaction.h"
#include "shading/texture_set.h"

namespace dapple {

// The scene and the textures must outlive this. All calls may come from many threads.
class MaterialEvaluator {
 public:
  MaterialEvaluator(const SceneView& scene, const TextureSet& textures);

  // `wo` is unit and points back along the path.
  Bsdf make_bsdf(MaterialId material, const SurfaceInteraction& at, const Vec3f& wo,
                 DispersionChannel dispersion = {}) const;

  // Nothing that BsdfChunk cannot hold. Then point() is what its Bsdf is made of.
  bool is_plain(MaterialId material) const { return traits_[index_of(material)].plain; }
  LayeredPoint point(MaterialId material, const SurfaceInteraction& at) const {
    return layered_point(*layered(material), at, textures_);
  }

  // The part of a path that meets the surface: below 1 it goes straight through with the rest.
  float opacity(MaterialId material, const SurfaceInteraction& at) const;
  // False: opacity is always 1.
  bool may_be_transparent(MaterialId material) const {
    return traits_[index_of(material)].transparent;
  }

  // Radiance, the same in every direction; from behind only if the material is double-sided.
  Vec3f emission(MaterialId material, const SurfaceInteraction& at) const;
  bool is_emissive(MaterialId material) const { return traits_[index_of(material)].emissive; }
  // False where a triangle with these corners in the emissive map's texture coordinates is dark.
  bool shines_within(MaterialId material, const std::array<Vec2f, 3>& corners) const;
  std::uint32_t emission_uv_set(MaterialId material) const;
  Vec3f greatest_emission(MaterialId material) const;  // where its texture is white

  // Shows its base colour whatever the light: the path ends here with unlit_colour() as radiance.
  bool is_unlit(MaterialId material) const { return traits_[index_of(material)].unlit; }
  Vec3f unlit_colour(MaterialId material, const SurfaceInteraction& at) const;

  // The medium that a transmitted path enters on the side the geometric normal points away from.
  bool has_interior(MaterialId material) const { return traits_[index_of(material)].interior; }
  Medium interior(MaterialId material) const;

 private:
  // What every vertex asks of a material.
  struct Traits {
    const LayeredMaterial* layered = nullptr;  // null: of a classic kind
    bool plain = false, transparent = false, emissive = false, unlit = false, interior = false;
  };
  const LayeredMaterial* layered(MaterialId material) const {
    return traits_[index_of(material)].layered;
  }

  SceneView scene_;
  std::vector<Traits> traits_;
  const TextureSet& textures_;
};

}  // namespace dapple
