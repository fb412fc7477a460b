// A path of light on its way through a lit scene.
#pragma once

#include <array>
#include <cstdint>

#include "math/ray.h"
#include "math/vec3.h"
#include "render/path_sampler.h"
#include "scene/material.h"
#include "shading/material_evaluator.h"

namespace dapple {

inline constexpr MaterialId kVacuum{0xffffffffu};

// The bodies that a ray is inside of, the last one entered first; what is in that one fills the
// space. One that is entered within three others makes the outermost forgotten.
struct Insides {
  static constexpr std::size_t kDepth = 4;
  std::array<MaterialId, kDepth> bodies{kVacuum, kVacuum, kVacuum, kVacuum};

  MaterialId innermost() const { return bodies[0]; }
  void enter(MaterialId body);
  // Bodies may overlap: the one that is left need not be the last one entered, nor have been
  // entered.
  void leave(MaterialId body);
};

struct LightPath {
  Vec3f throughput{1, 1, 1};
  Vec3f radiance;     // gathered so far
  float clamped = 0;  // sum over the channels of what a clamp took away
  // Where the ray comes from: what the choice of lights there was made with, to weigh what it
  // finds.
  Vec3f position;
  Vec3f normal;                 // zero in a medium
  float environment_share = 0;  // of the choice
  float pdf = 0;                // of the ray's direction; 0: no other strategy finds what it finds
  float cone_width = 0;
  float cone_spread = 0;  // growth of the width along the ray
  float alpha = 0;        // 1 once the path met something
  PathSampler::Place sample;
  std::uint32_t pixel = 0;  // of the tile
  Insides insides;
  std::uint16_t scatterings = 0;
  std::uint16_t vertices =
      0;                // scatterings and straight passages: what random numbers are keyed by
  bool passed = false;  // straight through something since `position`
  DispersionChannel dispersion;

  // Gathers light; what is brought after the first scattering is cut at `limit` unless that is 0.
  void add(const Vec3f& contribution, bool indirect, float limit);
};

// Light that reaches a path's vertex unless something stands in between.
struct ShadowRay {
  Ray ray;
  Vec3f contribution;
  std::uint32_t path = 0;
  bool indirect = false;
};

}  // namespace dapple
