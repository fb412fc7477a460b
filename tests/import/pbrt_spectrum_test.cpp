#include "import/pbrt/spectrum.h"

#include <gtest/gtest.h>

namespace dapple {
namespace {

TEST(PbrtSpectrum, AFlatReflectanceIsGreyAndEmissionHasLuminanceOne) {
  const auto flat = pbrt::make_spectrum({400, 0.5, 700, 0.5});
  ASSERT_TRUE(flat);
  const Vec3f grey = pbrt::reflectance_colour(*flat);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(grey[i], 0.5f, 1e-6f);
  for (const double kelvin : {1500.0, 2700.0, 9000.0, 20000.0}) {
    const Vec3f c = pbrt::blackbody_colour(kelvin);
    EXPECT_NEAR(0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z, 1, kelvin < 2000 ? 0.02 : 1e-5);
    EXPECT_EQ(c.x > c.z, kelvin < 7000) << kelvin;
  }
  EXPECT_FALSE(pbrt::make_spectrum({400, 1, 400, 2}));
  EXPECT_FALSE(pbrt::make_spectrum({400, 1, 500}));
}

TEST(PbrtSpectrum, MetalsHaveTheirColours) {
  const auto colour = [](std::string_view name) {
    const pbrt::Conductor* metal = pbrt::conductor_named(name);
    return metal == nullptr ? Vec3f() : pbrt::conductor_colour(metal->eta, metal->k);
  };
  const Vec3f gold = colour("Au"), copper = colour("Cu"), silver = colour("Ag");
  EXPECT_GT(gold.x, gold.y);
  EXPECT_GT(gold.y, gold.z);
  EXPECT_GT(copper.x, copper.y);
  EXPECT_GT(silver.z, 0.85f);
  EXPECT_EQ(pbrt::conductor_named("Xx"), nullptr);
}

}  // namespace
}  // namespace dapple
