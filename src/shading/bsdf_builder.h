// Assembles the Bsdf of a point for one direction of view.
#pragma once

#include "scene/material.h"
#include "shading/albedo_tables.h"
#include "shading/bsdf.h"
#include "shading/layered_point.h"
#include "shading/surface_interaction.h"

namespace dapple {

// Which colour channel's index of refraction a path follows through dispersive surfaces.
struct DispersionChannel {
  int channel = 0;     // 0 to 2, uniformly random per path
  bool alone = false;  // the path carries no other (BsdfSample::one_channel)
};

// What each layer reflects is taken from what those below it get, on the way to wo alone: so much
// light as a white surface receives it gives back, while the exchange of the two directions holds
// only within a layer.
class BsdfBuilder {
 public:
  BsdfBuilder(const SurfaceInteraction& at, const Vec3f& wo);

  Bsdf layered(const LayeredPoint& point, DispersionChannel dispersion);
  Bsdf classic(const Material& material);

 private:
  // Albedos of the interface for wo.
  struct Interface {
    float total = 1;        // of single scattering between perfectly reflecting facets
    Vec3f dielectric;       // of the opaque dielectric, multiple scattering included
    float attenuation = 1;  // what the dielectric lets through
  };

  void set_frame(const Vec3f& normal, const Vec3f& tangent);
  void set_width(float alpha_x, float alpha_y);
  float add_coat(const LayeredPoint& point);
  float add_sheen(const LayeredPoint& point);
  Interface add_interface(const LayeredPoint& point, float below_layers);
  void add_glass(const LayeredPoint& point, DispersionChannel dispersion, float weight);
  void add_reflection(const Vec3f& f0, const Vec3f& f90, float weight);
  Bsdf finish();

  const SurfaceInteraction& at_;
  Vec3f world_wo_;
  float side_;  // +1: seen from outside
  Bsdf bsdf_;
  float roughness_ = 1;  // of the interface, for the tables
  ReflectionAlbedo facets_;
  float glass_albedo_ = 1, coat_albedo_ = 0, sheen_albedo_ = 0;
};

}  // namespace dapple
