// White furnace: a white surface under light of 1 from everywhere looks as if it were not there.
#include <gtest/gtest.h>

#include "math/random.h"
#include "tests/shading/surface_cases.h"

namespace dapple::test {
namespace {

// The mean weight of stratified samples.
double reflected(const Bsdf& bsdf) {
  constexpr std::uint32_t kGrid = 40;
  double sum = 0;
  std::uint32_t n = 0;
  for (std::uint32_t i = 0; i < kGrid; ++i) {
    for (std::uint32_t j = 0; j < kGrid; ++j) {
      for (std::uint32_t k = 0; k < kGrid; ++k) {
        const auto u = uniform4(i, j, k, 0, 7);
        const auto in_cell = [](std::uint32_t cell, float within) {
          return (static_cast<float>(cell) + within) / kGrid;
        };
        ++n;
        if (const auto s = bsdf.sample(in_cell(k, u[2]), {in_cell(i, u[0]), in_cell(j, u[1])})) {
          sum += (s->weight.x + s->weight.y + s->weight.z) / 3;
        }
      }
    }
  }
  return sum / n;
}

class Furnace : public testing::TestWithParam<float> {};

TEST_P(Furnace, WhiteSurfacesGiveBackAllLight) {
  for (const SurfaceCase& surface : surface_cases(GetParam())) {
    for (const float cosine : {0.05f, 0.2f, 0.5f, 0.8f, 1.0f}) {
      const Bsdf bsdf = bsdf_of(surface, direction_at(cosine, 0.1f));
      const double tolerance = cosine < 0.1f ? surface.grazing_tolerance : surface.energy_tolerance;
      EXPECT_NEAR(reflected(bsdf), 1, tolerance) << surface.name << " at cosine " << cosine;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Roughness, Furnace,
                         testing::Values(0.0f, 0.05f, 0.2f, 0.4f, 0.6f, 0.8f, 1.0f));

}  // namespace
}  // namespace dapple::test
