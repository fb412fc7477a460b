// How the materials of the reference tracer scatter, in the textbook's words: points of balls by
// rejection, refraction by angles.
#pragma once

#include <optional>
#include <random>

#include "scene/material.h"
#include "tests/reference/reference_shapes.h"

namespace dapple::test {

using ReferenceRandom = std::mt19937_64;

// Uniform in [0, 1).
double random_number(ReferenceRandom& random);
Triple random_in_disc(ReferenceRandom& random);
Triple random_in_ball(ReferenceRandom& random);

struct ReferenceScattering {
  Triple direction;
  Triple attenuation;
};

// No value when the ray is absorbed.
std::optional<ReferenceScattering> scatter_reference(const ReferenceHit& hit,
                                                     const Triple& direction,
                                                     ReferenceRandom& random);

}  // namespace dapple::test
