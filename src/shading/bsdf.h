// The reflectance of one point of a surface for one direction of view, textures already applied.
#pragma once

#include <optional>

#include "math/frame.h"
#include "math/vec2.h"
#include "math/vec3.h"

namespace dapple {

struct BsdfValue {
  Vec3f f;        // f |cos(wi)|
  float pdf = 0;  // over solid angle; that of sample()
};

struct BsdfSample {
  Vec3f wi;
  Vec3f weight;              // f |cos(wi)| / pdf
  float pdf = 0;             // over solid angle; 0 when specular
  float roughness = 1;       // of the chosen lobe, how far it widens a ray cone
  bool specular = false;     // one direction of a set without area: no other strategy finds it
  bool transmitted = false;  // to the other side of the geometric surface
  bool one_channel = false;  // from here on the path carries the chosen channel alone
};

// Plain data. Directions are unit vectors in world space and point away from the surface; wo is
// the one that the Bsdf was made for (MaterialEvaluator::make_bsdf).
class Bsdf {
 public:
  // Lobes of one direction are left out.
  BsdfValue evaluate(const Vec3f& wi) const;
  Vec3f value(const Vec3f& wi) const { return evaluate(wi).f; }
  float pdf(const Vec3f& wi) const { return evaluate(wi).pdf; }
  // No value when the path ends here. Numbers in [0, 1).
  std::optional<BsdfSample> sample(float u_lobe, Vec2f u) const;

  // What part of uniform light from everywhere the point sends to wo, nearly.
  Vec3f albedo() const { return albedo_; }
  bool is_specular_only() const { return specular_only_; }

 private:
  friend class BsdfBuilder;

  Frame frame_;
  Vec3f geometric_normal_{0, 0, 1};  // on the side of wo
  Vec3f wo_;                         // local
  Vec3f diffuse_;
  Vec3f f0_;
  float f90_ = 1;
  float alpha_ = 1;
  float p_diffuse_ = 1;
  Vec3f albedo_;
  bool specular_only_ = false;
};

}  // namespace dapple
