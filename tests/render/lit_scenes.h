// Small scenes for the light transport of models, whose pictures are known in closed form.
#pragma once

#include "render/render_job.h"
#include "scene/scene.h"

namespace dapple::test {

// Seen from `distance` along +z, in parallel, `height` of the world over the picture's height.
Scene empty_lit_scene(double height, double distance = 10);

MaterialId add_layered(Scene& scene, const LayeredMaterial& material);
MaterialId add_diffuse(Scene& scene, float albedo);
MaterialId add_emitter(Scene& scene, float radiance);

struct LitPicture {
  int side = 16;
  int samples = 64;
  int max_scatterings = 32;
  bool transparent = false;
  float clamp_indirect = 0;
};
RenderResult render_lit(const Scene& scene, const LitPicture& picture = {});

// Of all channels and pixels.
double mean_of(const Image& image);

}  // namespace dapple::test
