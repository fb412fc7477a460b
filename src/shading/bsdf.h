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
  float roughness = 1;       // of the chosen lobe, 0 to 1: how far it widens a ray cone
  bool specular = false;     // one direction of a set without area: no other strategy finds it
  bool transmitted = false;  // to the other side of the geometric surface
  bool one_channel = false;  // from here on the path carries the dispersion's channel alone
};

// Lobes, from the outside in, each holding what the layers above it let through on the way to wo:
// a clear coat; sheen; an interface of microfacets that reflects and, where the material
// transmits, refracts or lets through straight; Lambertian reflection and transmission.
// Radiance is carried as that in vacuum: crossing into a denser medium does not scale it.
//
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
  // Nothing but lobes of one direction: asking lights is of no use.
  bool is_specular_only() const { return specular_only_; }

 private:
  friend class BsdfBuilder;

  // What a facet of the interface does, by the cosine of wo to its normal.
  struct Facet {
    Vec3f reflected, transmitted;
    float p_reflect;  // of choosing reflection
  };
  Facet facet(float cosine) const;
  Facet glass_facet(float cosine) const;  // of the part that refracts, without the choice

  BsdfValue evaluate_reflection(const Vec3f& wi) const;    // local, above the surface
  BsdfValue evaluate_transmission(const Vec3f& wi) const;  // local, below the surface
  void add_coat(const Vec3f& wi, BsdfValue& value) const;
  void add_interface_reflection(const Vec3f& wi, BsdfValue& value) const;
  void add_refraction(const Vec3f& wi, BsdfValue& value) const;
  void add_straight_through(const Vec3f& wi, BsdfValue& value) const;

  std::optional<BsdfSample> sample_coat(Vec2f u) const;
  std::optional<BsdfSample> sample_interface(float u_choice, Vec2f u) const;
  std::optional<BsdfSample> finish(const Vec3f& local_wi, float roughness, bool transmitted) const;
  std::optional<BsdfSample> finish_specular(const Vec3f& local_wi, const Vec3f& weight,
                                            bool transmitted) const;

  Frame frame_;                      // its normal on the side of wo
  Vec3f geometric_normal_{0, 0, 1};  // on the side of wo
  Vec3f wo_{0, 0, 1};                // local
  Vec3f albedo_;

  // Probabilities of choosing a lobe; they sum to 1.
  float p_coat_ = 0, p_interface_ = 0, p_diffuse_ = 0, p_through_ = 0;

  Vec3f diffuse_;  // albedo of the Lambertian reflection
  Vec3f through_;  // and of the Lambertian transmission
  Vec3f sheen_;    // factor of a white sheen
  float sheen_roughness_ = 0;

  float alpha_x_ = 1, alpha_y_ = 1;  // of the interface
  // The interface where it does not transmit: Schlick's Fresnel term, every factor included.
  Vec3f f0_, f90_minus_f0_;
  // And where it does.
  Vec3f glass_f0_, glass_tint_;  // tint: of what goes through
  float glass_ = 0;              // part of the surface, every factor included
  float glass_f90_ = 1;
  float eta_ = 1;   // index of the far side over that of the near one
  Vec3f straight_;  // factor of going straight through a thin wall

  Vec3f coat_normal_{0, 0, 1};  // local
  float coat_ = 0;              // part of the surface, every factor included
  float coat_alpha_ = 1;

  bool mirror_ = false;  // the interface has lobes of one direction
  bool coat_mirror_ = false;
  bool specular_only_ = false;
  bool one_channel_ = false;  // refraction leaves one channel
};

}  // namespace dapple
