#include "shading/light_set.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/fast_functions.h"
#include "math/random.h"
#include "tests/shading/lit_room.h"

namespace dapple::test {
namespace {

constexpr double kExactPi = 3.14159265358979323846;

// Irradiance at the origin of a surface that faces up, nothing in the way.
struct Estimate {
  double mean = 0, error = 0;  // standard error
};
Estimate irradiance(const LightSet& lights, const Vec3f& normal = {0, 0, 1}) {
  constexpr std::uint32_t kSamples = 100'000;
  double sum = 0, squares = 0;
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    const auto u = uniform4(i, 0, 0, 0, 17);
    const auto s = lights.sample({0, 0, 0}, normal, u[0], {u[1], u[2]});
    if (!s) continue;
    const double cosine = std::fmax(dot(s->wi, normal), 0.0f);
    const double value = s->radiance.y * cosine / s->pdf;
    sum += value;
    squares += value * value;
  }
  const double mean = sum / kSamples;
  return {mean, std::sqrt(std::fmax(squares / kSamples - mean * mean, 0.0) / kSamples)};
}

void expect_irradiance(const Scene& scene, double expected) {
  const LitView lit(scene);
  const Estimate found = irradiance(lit.lights);
  EXPECT_NEAR(found.mean, expected, 4 * found.error + 1e-4 * expected);
  EXPECT_LT(found.error, 0.02 * expected);
}

TEST(LightSet, SphereGivesItsKnownIrradiance) {
  for (const double angle : {0.0, 0.5, 1.0}) {
    LitRoom room;
    room.scene.add_sphere({{3 * std::sin(angle), 0, 3 * std::cos(angle)}, 1},
                          room.add_glow({2, 2, 2}));
    expect_irradiance(room.scene, 2 * kExactPi / 9 * std::cos(angle));
  }
}

TEST(LightSet, ASphereAroundThePointGivesPi) {
  LitRoom room;
  room.scene.add_sphere({{0.2, 0.3, 0.1}, 2}, room.add_glow({1, 1, 1}));
  expect_irradiance(room.scene, kExactPi);
}

// A rectangle parallel to the receiver with one corner above it, of sides a and b at distance 1.
double corner_form_factor(double a, double b) {
  const double x = std::sqrt(1 + a * a), y = std::sqrt(1 + b * b);
  return (a / x * std::atan(b / x) + b / y * std::atan(a / y)) / (2 * kExactPi);
}

TEST(LightSet, RectangleGivesItsKnownIrradiance) {
  LitRoom room;
  room.scene.add_rectangle(ShapeKind::xy_rectangle, {0, 2, 0, 0.7, 1}, room.add_glow({3, 3, 3}));
  expect_irradiance(room.scene, 3 * kExactPi * corner_form_factor(2, 0.7));
}

TEST(LightSet, TrianglesGiveTheIrradianceOfTheirRectangle) {
  LitRoom room;
  const MaterialId glow = room.add_glow({3, 3, 3});
  room.add_triangle({0, 0, 1}, {2, 0, 1}, {0, 0.7f, 1}, glow);
  room.add_triangle({2, 0, 1}, {2, 0.7f, 1}, {0, 0.7f, 1}, glow);
  expect_irradiance(room.scene, 3 * kExactPi * corner_form_factor(2, 0.7));
}

TEST(LightSet, InstancesShineWhereTheyStand) {
  LitRoom room;
  const MaterialId glow = room.add_glow({3, 3, 3});
  room.add_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, glow);
  room.add_triangle({1, 0, 0}, {1, 1, 0}, {0, 1, 0}, glow);
  room.scene.prototypes.push_back({0, 2});
  Instance instance;
  instance.to_world.rows[0][0] = 2;
  instance.to_world.rows[1][1] = 0.7f;
  instance.to_world.rows[2][3] = 1;
  room.scene.instances.push_back(instance);
  expect_irradiance(room.scene, 3 * kExactPi * corner_form_factor(2, 0.7));
}

TEST(LightSet, LampsHaveTheUnitsOfGltf) {
  LitRoom room;
  room.scene.lights.push_back(
      {.kind = LightKind::point, .position = {0, 0, 2}, .intensity = {0, 8, 0}});
  const LitView point(room.scene);
  EXPECT_NEAR(irradiance(point.lights).mean, 2, 1e-4);
  room.scene.lights[0].kind = LightKind::directional;
  const LitView sun(room.scene);
  EXPECT_NEAR(irradiance(sun.lights).mean, 8, 1e-4);
}

TEST(LightSet, SpotsFallOffBetweenTheirAngles) {
  LitRoom room;
  room.scene.lights.push_back(
      {.kind = LightKind::spot, .position = {0, 0, 1}, .intensity = {1, 1, 1}});
  Light& spot = room.scene.lights[0];
  spot.inner_angle = 0.2f, spot.outer_angle = 0.6f;
  const auto at_angle = [&](double angle) {
    spot.direction = {static_cast<float>(std::sin(angle)), 0, -static_cast<float>(std::cos(angle))};
    return irradiance(LitView(room.scene).lights).mean;
  };
  EXPECT_NEAR(at_angle(0.1), 1, 1e-4);
  EXPECT_EQ(at_angle(0.7), 0);
  const double t = (std::cos(0.4) - std::cos(0.6)) / (std::cos(0.2) - std::cos(0.6));
  EXPECT_NEAR(at_angle(0.4), t * t, 1e-3);
}

// A room with every kind of light.
Scene mixed_room() {
  LitRoom room;
  const MaterialId glow = room.add_glow({1, 1, 1}), bright = room.add_glow({20, 10, 5});
  room.scene.add_sphere({{1, 2, 3}, 0.5}, bright);
  room.scene.add_rectangle(ShapeKind::xz_rectangle, {0, 2, 1, 2, -3}, glow);
  room.scene.add_rectangle(ShapeKind::yz_rectangle, {0, 2, 1, 2, 4}, glow);
  room.add_triangle({0, 0, 5}, {1, 0, 5}, {0, 1, 6}, bright);
  room.scene.cylinders.push_back({{-2, 0, 1}, {-2, 1, 2}, 0.3});
  room.scene.cylinder_materials.push_back(glow);
  room.scene.environment.kind = EnvironmentKind::constant;
  room.scene.environment.colour = {0.1f, 0.1f, 0.1f};
  room.scene.lights.emplace_back().kind = LightKind::directional;
  return room.scene;
}

// What sample() says of its density, the functions for hits say too.
TEST(LightSet, DensitiesAgreeWithThoseOfHits) {
  const Scene scene = mixed_room();
  const LitView lit(scene);
  const EmitterShapes shapes(lit.view);
  const EmitterId emitters[] = {{EmitterKind::sphere, 0},
                                {EmitterKind::xz_rectangle, 0},
                                {EmitterKind::yz_rectangle, 0},
                                {EmitterKind::triangle, 0},
                                {EmitterKind::cylinder, 0}};
  const Vec3f position(0.3f, -0.2f, 0.1f), normal(0, 0, 1);
  double total = 0;
  for (const EmitterId& emitter : emitters) {
    const auto point = shapes.sample(emitter, position, {0.3f, 0.6f});
    ASSERT_TRUE(point);
    const float alone =
        shapes.pdf(emitter, position, point->wi, point->distance, point->surface.geometric_normal);
    EXPECT_NEAR(alone, point->pdf, 1e-4f * alone);
    const float all = lit.lights.pdf_of_hit(emitter, position, normal, point->wi, point->distance,
                                            point->surface.geometric_normal);
    EXPECT_GT(all, 0);
    total += all / alone;
  }
  const float environment = lit.lights.pdf_of_environment(position, normal, {0, 0, 1});
  total += environment * 4 * kExactPi;
  EXPECT_LT(total, 1);  // the rest is the directional light's
  double directional = 0;
  for (std::uint32_t i = 0; i < 10'000; ++i) {
    const float u = (static_cast<float>(i) + 0.5f) / 10'000;
    const auto s = lit.lights.sample(position, normal, u, {0.4f, 0.7f});
    if (s && s->delta) directional += 1e-4;
  }
  EXPECT_NEAR(total + directional, 1, 1e-3);
}

TEST(LightSet, NoLightIsNoSample) {
  const LitRoom room;
  const LitView lit(room.scene);
  EXPECT_TRUE(lit.lights.empty());
  EXPECT_FALSE(lit.lights.sample({0, 0, 0}, {0, 0, 1}, 0.5f, {0.5f, 0.5f}));
  EXPECT_EQ(lit.lights.pdf_of_environment({0, 0, 0}, {0, 0, 1}, {0, 0, 1}), 0);
}

}  // namespace
}  // namespace dapple::test
