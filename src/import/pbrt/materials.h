// Materials and media of a pbrt scene.
#pragma once

#include <map>
#include <string>

#include "import/pbrt/textures.h"

namespace dapple::pbrt {

// From a material of pbrt-v4, or one of those of pbrt-v3 that most scenes use: matte, mirror,
// glass, plastic and metal. One that has no counterpart is grey, with a warning.
[[nodiscard]] Expected<LayeredMaterial> make_material(const Context& context,
                                                      const Textures& textures,
                                                      const std::string& kind,
                                                      const Params& params);

struct Medium {
  Vec3f absorption, scattering;  // per unit of length
  float g = 0;
};

[[nodiscard]] Expected<Medium> make_medium(const Context& context, const Params& params);

// Fills the inside of a material that lets light in.
void fill_with(const Medium& medium, LayeredMaterial& material);

}  // namespace dapple::pbrt
