// Fresnel's equations, the thin film, and tables against the integrals they stand for.
#include <gtest/gtest.h>

#include <cmath>

#include "shading/albedo_integrals.h"
#include "shading/albedo_tables.h"
#include "shading/fresnel.h"
#include "shading/thin_film.h"

namespace dapple::test {
namespace {

// From the two polarisations' amplitudes.
double exact_reflectance(double cosine, double eta) {
  const double sin2 = (1 - cosine * cosine) / (eta * eta);
  if (sin2 >= 1) return 1;
  const double inside = std::sqrt(1 - sin2);
  const double s = (cosine - eta * inside) / (cosine + eta * inside);
  const double p = (eta * cosine - inside) / (eta * cosine + inside);
  return (s * s + p * p) / 2;
}

TEST(Fresnel, HasItsKnownValues) {
  EXPECT_NEAR(fresnel_dielectric(1, 1.5f), 0.04, 1e-6);
  EXPECT_NEAR(fresnel_dielectric(0, 1.5f), 1, 1e-6);
  EXPECT_EQ(fresnel_dielectric(0.5f, 1 / 1.5f), 1);  // beyond the critical angle, cosine 0.745
  // At Brewster's angle only one polarisation is reflected.
  const double brewster = std::cos(std::atan(1.5));
  const double inside = std::sin(std::atan(1.5)) / 1.5;
  const double s = std::sin(std::atan(1.5) - std::asin(inside));
  EXPECT_NEAR(fresnel_dielectric(static_cast<float>(brewster), 1.5f), s * s / 2, 1e-6);
  for (const float eta : {0.4f, 0.7f, 1.3f, 2.4f}) {
    for (float cosine = 0.01f; cosine <= 1; cosine += 0.01f) {
      EXPECT_NEAR(fresnel_dielectric(cosine, eta), exact_reflectance(cosine, eta), 1e-5);
    }
  }
}

TEST(AlbedoTables, HoldTheIntegrals) {
  for (const float roughness : {0.2f, 0.37f, 0.62f, 0.93f}) {
    for (const float cosine : {0.05f, 0.3f, 0.71f, 1.0f}) {
      const SplitAlbedo exact = integrate_reflection(cosine, roughness, 64);
      const ReflectionAlbedo table = reflection_albedo(cosine, roughness);
      EXPECT_NEAR(table.scale, exact.scale, 0.01);
      EXPECT_NEAR(table.bias, exact.bias, 0.01);
      for (const float eta : {1.005f, 1.03f, 1.1f, 1.2f, 1.5f, 2.0f}) {
        EXPECT_NEAR(refraction_albedo(cosine, roughness, eta),
                    integrate_refraction(cosine, roughness, eta, 64), 0.02);
        EXPECT_NEAR(refraction_albedo(cosine, roughness, 1 / eta),
                    integrate_refraction(cosine, roughness, 1 / eta, 64), 0.02);
      }
      for (const float azimuth : {0.2f, 0.8f}) {
        const float sine = std::sqrt(1 - cosine * cosine), narrow = roughness * roughness;
        const Vec3f wo(sine * azimuth, sine * std::sqrt(1 - azimuth * azimuth), cosine);
        const SplitAlbedo uneven = integrate_brushed(cosine, azimuth, 0.95f, roughness, 64);
        const ReflectionAlbedo found = brushed_albedo(wo, 0.95f * 0.95f, narrow);
        EXPECT_NEAR(found.scale, uneven.scale, 0.02);
        EXPECT_NEAR(found.bias, uneven.bias, 0.02);
      }
      EXPECT_NEAR(sheen_albedo(cosine, roughness), integrate_sheen(cosine, roughness, 128), 0.02);
    }
  }
}

TEST(ThinFilm, VanishesWithItsThickness) {
  const Vec3f f0(0.04f, 0.2f, 0.5f);
  const Vec3f found = thin_film_reflectance(1, 1.3f, 0, f0);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], f0[c], 0.02);
}

TEST(ThinFilm, ColoursByThickness) {
  float most = 0;
  for (float nm = 100; nm <= 800; nm += 10) {
    for (const float cosine : {0.1f, 0.5f, 1.0f}) {
      const Vec3f r = thin_film_reflectance(cosine, 1.8f, nm, {0.04f, 0.04f, 0.04f});
      for (int c = 0; c < 3; ++c) {
        EXPECT_GE(r[c], 0);
        EXPECT_LE(r[c], 1);
      }
      most = std::fmax(most, std::fabs(r.x - r.z));
    }
  }
  EXPECT_GT(most, 0.1f);
}

}  // namespace
}  // namespace dapple::test
