// Assembles the Bsdf of a point for one direction of view.
#pragma once

#include "scene/material.h"
#include "shading/bsdf.h"
#include "shading/surface_interaction.h"

namespace dapple {

class BsdfBuilder {
 public:
  BsdfBuilder(const SurfaceInteraction& at, const Vec3f& wo);

  void metallic_roughness(const Vec3f& base_colour, float metallic, float roughness);
  void classic(const Material& material);

  Bsdf build();

 private:
  Bsdf bsdf_;
};

}  // namespace dapple
