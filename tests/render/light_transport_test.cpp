// Pictures whose radiance is known in closed form. Tolerances are several standard errors of the
// means, measured with other seeds; the pictures themselves are always the same.
#include <gtest/gtest.h>

#include <cmath>

#include "render/light_path.h"
#include "tests/render/lit_scenes.h"

namespace dapple::test {
namespace {

// A wall that fills the picture, facing the camera.
void add_wall(Scene& scene, MaterialId material, double half = 100, double z = 0) {
  scene.add_rectangle(ShapeKind::xy_rectangle, {-half, half, -half, half, z}, material);
}

TEST(LightTransport, NothingIsBlackAndTransparent) {
  LitPicture picture;
  picture.transparent = true;
  const RenderResult result = render_lit(empty_lit_scene(1), picture);
  EXPECT_EQ(mean_of(result.image), 0);
  for (const float alpha : result.image.alpha) EXPECT_EQ(alpha, 0);
}

TEST(LightTransport, BackgroundIsTheEnvironment) {
  Scene scene = empty_lit_scene(1);
  scene.environment.kind = EnvironmentKind::constant;
  scene.environment.colour = {0.5f, 1, 2};
  for (const Vec3f& pixel : render_lit(scene).image.pixels) {
    EXPECT_LT(max_abs_component(pixel - Vec3f(0.5f, 1, 2)), 1e-5f);
  }
}

// Furnace: in uniform light a diffuse ball of albedo a shows radiance a everywhere.
TEST(LightTransport, ConvexDiffuseBallInUniformLight) {
  Scene scene = empty_lit_scene(1);
  scene.environment.kind = EnvironmentKind::constant;
  scene.add_sphere({{0, 0, 0}, 1}, add_diffuse(scene, 0.6f));
  const RenderResult result = render_lit(scene);
  EXPECT_NEAR(mean_of(result.image), 0.6, 0.002);
  EXPECT_EQ(result.dropped_samples, 0u);
}

// A closed room of albedo a and emission e: radiance e / (1 - a) everywhere, from paths of any
// length.
TEST(LightTransport, ClosedRoomOfKnownAlbedo) {
  Scene scene = empty_lit_scene(1, 0.5);
  LayeredMaterial walls;
  walls.base_colour = {0.5f, 0.5f, 0.5f};
  walls.specular = 0;
  walls.emission = {1, 1, 1};
  scene.add_sphere({{0, 0, 0}, 2}, add_layered(scene, walls));
  LitPicture picture;
  picture.max_scatterings = 60;
  picture.samples = 256;
  EXPECT_NEAR(mean_of(render_lit(scene, picture).image), 2, 0.01);
}

// Irradiance of a disc-shaped source, here the ball of radius r at distance d over a wall:
// radiance L (r / d)^2 times albedo [Lambert: E = pi L sin^2 of its angular radius].
TEST(LightTransport, DirectLightOfABall) {
  Scene scene = empty_lit_scene(0.01);
  add_wall(scene, add_diffuse(scene, 0.8f));
  scene.add_sphere({{0, 0, 20}, 3}, add_emitter(scene, 5));  // behind the camera
  const double expected = 0.8 * 5 * 9 / 400;
  LitPicture picture;
  picture.max_scatterings = 1;
  EXPECT_NEAR(mean_of(render_lit(scene, picture).image), expected, 0.005 * expected);
}

// The form factor of a parallel rectangle over the point below its corner [Howell, C-11]; four of
// them make the one above the centre.
TEST(LightTransport, DirectLightOfARectangle) {
  const double side = 4, distance = 5;
  Scene scene = empty_lit_scene(0.01, 1);
  add_wall(scene, add_diffuse(scene, 0.8f));
  scene.add_rectangle(ShapeKind::xy_rectangle, {-side, side, -side, side, distance},
                      add_emitter(scene, 2));
  const double x = side / distance, root = std::sqrt(1 + x * x);
  const double corner = x / root * std::atan(x / root) / M_PI;  // both halves of the formula alike
  const double expected = 0.8 * 2 * 4 * corner;
  LitPicture picture;
  picture.max_scatterings = 1;
  EXPECT_NEAR(mean_of(render_lit(scene, picture).image), expected, 0.01 * expected);
}

// A one-sided lamp lights only what its outward side sees.
TEST(LightTransport, OneSidedEmittersAreDarkBehind) {
  Scene scene = empty_lit_scene(0.01, 1);
  add_wall(scene, add_diffuse(scene, 0.8f));
  const MaterialId lamp = add_emitter(scene, 2);
  scene.layered_materials.back().double_sided = 0;
  // The outward side of an xy rectangle is +z, away from the wall.
  scene.add_rectangle(ShapeKind::xy_rectangle, {-4, 4, -4, 4, 5}, lamp);
  LitPicture picture;
  picture.max_scatterings = 1;
  EXPECT_EQ(mean_of(render_lit(scene, picture).image), 0);
  scene.rectangles[0][1].k = -5;  // behind the wall, shining at its back
  scene.camera.look_from = {0, 0, -1};
  EXPECT_GT(mean_of(render_lit(scene, picture).image), 0.1);
}

TEST(LightTransport, PointLightFallsWithTheSquareOfTheDistance) {
  Scene scene = empty_lit_scene(0.01);
  add_wall(scene, add_diffuse(scene, 0.8f));
  scene.lights.push_back({LightKind::point, {0, 3, 4}, {0, 0, -1}, {10, 10, 10}, 0, 0});
  // I cos / d^2 * albedo / pi with cos = 4 / 5.
  const double expected = 10 * 0.8 / 25 * 0.8 / M_PI;
  EXPECT_NEAR(mean_of(render_lit(scene).image), expected, 0.002 * expected);
}

TEST(LightTransport, DirectionalLightIsIrradiance) {
  Scene scene = empty_lit_scene(1);
  add_wall(scene, add_diffuse(scene, 0.5f));
  Light sun{LightKind::directional, {}, {0.6f, 0, -0.8f}, {3, 3, 3}, 0, 0};
  scene.lights.push_back(sun);
  const double expected = 3 * 0.8 * 0.5 / M_PI;
  EXPECT_NEAR(mean_of(render_lit(scene).image), expected, 1e-3 * expected);
}

TEST(LightTransport, SpotLightsOnlyWithinItsCone) {
  Scene scene = empty_lit_scene(20);
  add_wall(scene, add_diffuse(scene, 1));
  scene.lights.push_back({LightKind::spot, {0, 0, 10}, {0, 0, -1}, {1, 1, 1}, 0.3f, 0.4f});
  const Image image = render_lit(scene).image;
  EXPECT_EQ(image.at(0, 0), Vec3f());  // about 0.9 rad off the axis
  EXPECT_NEAR(image.at(8, 8).x, 1 / (M_PI * 100), 2e-4);
}

TEST(LightTransport, ShadowsAreBlackWithoutOtherLight) {
  Scene scene = empty_lit_scene(0.5);
  const MaterialId grey = add_diffuse(scene, 0.5f);
  add_wall(scene, grey);
  scene.add_rectangle(ShapeKind::xy_rectangle, {-5, 5, -5, 5, 20}, grey);
  scene.lights.push_back({LightKind::point, {0, 0, 30}, {0, 0, -1}, {1000, 1000, 1000}, 0, 0});
  LitPicture picture;
  picture.max_scatterings = 1;
  EXPECT_EQ(mean_of(render_lit(scene, picture).image), 0);
}

LayeredMaterial veil(float alpha) {
  LayeredMaterial material;
  material.alpha = alpha;
  material.alpha_mode = AlphaMode::blend;
  material.base_colour = {0, 0, 0};
  material.specular = 0;
  return material;
}

// Two veils in front of the background: each lets 1 - alpha through.
TEST(LightTransport, BlendedSurfacesLetTheRestThrough) {
  Scene scene = empty_lit_scene(1);
  scene.environment.kind = EnvironmentKind::constant;
  const MaterialId material = add_layered(scene, veil(0.25f));
  add_wall(scene, material, 100, 0);
  add_wall(scene, material, 100, 1);
  LitPicture picture;
  picture.samples = 1024;
  EXPECT_NEAR(mean_of(render_lit(scene, picture).image), 0.5625, 0.003);
  picture.transparent = true;
  const Image image = render_lit(scene, picture).image;
  double alpha = 0;
  for (const float a : image.alpha) alpha += a / static_cast<double>(image.alpha.size());
  EXPECT_NEAR(alpha, 1 - 0.5625, 0.003);
  EXPECT_EQ(mean_of(image), 0);
}

TEST(LightTransport, ShadowRaysPassThroughBlendedSurfaces) {
  Scene scene = empty_lit_scene(0.01);
  add_wall(scene, add_diffuse(scene, 1));
  const MaterialId material = add_layered(scene, veil(0.25f));
  add_wall(scene, material, 100, 20);
  add_wall(scene, material, 100, 21);
  scene.lights.push_back({LightKind::directional, {}, {0, 0, -1}, {M_PI, M_PI, M_PI}, 0, 0});
  EXPECT_NEAR(mean_of(render_lit(scene).image), 0.5625, 0.002);
}

// Behind a slab that only absorbs, radiance falls as Beer's law says; the slab is thick, of the
// index of its surroundings, so that nothing is reflected.
TEST(LightTransport, BeerLambertThroughASlab) {
  Scene scene = empty_lit_scene(0.5);
  scene.environment.kind = EnvironmentKind::constant;
  LayeredMaterial glass;
  glass.transmission = 1;
  glass.roughness = 0;
  glass.ior = 1;
  glass.thickness = 1;
  glass.attenuation_distance = 2;
  glass.attenuation_colour = {0.5f, 0.25f, 1};
  scene.add_sphere({{0, 0, 0}, 100}, add_layered(scene, glass));
  scene.camera.look_from = {0, 0, 200};
  const Vec3f pixel = render_lit(scene).image.at(8, 8);
  EXPECT_NEAR(pixel.x, std::pow(0.5, 100), 1e-6);
  EXPECT_NEAR(pixel.z, 1, 1e-3);
  Scene thin = scene;
  thin.spheres[0].radius = 1;
  const Vec3f near = render_lit(thin).image.at(8, 8);
  EXPECT_NEAR(near.x, 0.5, 0.01);  // the chord is a little shorter off the centre
  EXPECT_NEAR(near.y, 0.25, 0.01);
}

// A ball that takes `colour` of the light on each unit of length, of the index of its surroundings.
void add_clear_ball(Scene& scene, double z, double radius, const Vec3f& colour) {
  LayeredMaterial clear;
  clear.transmission = 1;
  clear.roughness = 0;
  clear.ior = 1;
  clear.thickness = 1;
  clear.attenuation_distance = 1;
  clear.attenuation_colour = colour;
  scene.add_sphere({{0, 0, z}, radius}, add_layered(scene, clear));
}

Vec3d mean_colour(const Image& image) {
  Vec3d sum;
  for (const Vec3f& pixel : image.pixels) sum = sum + Vec3d(pixel);
  return sum / static_cast<double>(image.pixels.size());
}

// One in another: each part of the way counts with what fills the innermost ball there.
TEST(LightTransport, BeerLambertThroughNestedBodies) {
  Scene scene = empty_lit_scene(0.01, 20);
  scene.environment.kind = EnvironmentKind::constant;
  add_clear_ball(scene, 0, 3, {0.9f, 0.5f, 1});
  add_clear_ball(scene, 0, 2, {0.8f, 1, 0.7f});
  add_clear_ball(scene, 0.5, 0.5, {1, 1, 1});  // a bubble
  LitPicture picture;
  picture.samples =
      512;  // by the last of six surfaces Russian roulette has ended half of the paths
  const Vec3d mean = mean_colour(render_lit(scene, picture).image);
  EXPECT_NEAR(mean.x, std::pow(0.9, 2) * std::pow(0.8, 3), 3e-3);
  EXPECT_NEAR(mean.y, std::pow(0.5, 2), 3e-3);
  EXPECT_NEAR(mean.z, std::pow(0.7, 3), 3e-3);
}

// Where two overlap, the one that was entered later fills the space; leaving the first one, within
// the second, changes nothing.
TEST(LightTransport, BeerLambertThroughOverlappingBodies) {
  Scene scene = empty_lit_scene(0.01, 20);
  scene.environment.kind = EnvironmentKind::constant;
  add_clear_ball(scene, 1, 2, {0.9f, 1, 1});   // from z = 3 to -1
  add_clear_ball(scene, -1, 2, {1, 0.8f, 1});  // from z = 1 to -3
  const Vec3f pixel = render_lit(scene).image.at(8, 8);
  EXPECT_NEAR(pixel.x, std::pow(0.9, 2), 1e-3);
  EXPECT_NEAR(pixel.y, std::pow(0.8, 4), 1e-3);
}

// A wall in the middle of a ball that absorbs, a lamp in there too: light loses on its way to the
// wall and from there to the camera outside.
TEST(LightTransport, LampsShineThroughTheMediumAroundASurface) {
  Scene scene = empty_lit_scene(0.01, 20);
  add_clear_ball(scene, 0, 5, {0.9f, 0.8f, 1});
  add_wall(scene, add_diffuse(scene, 0.5f), 1);
  scene.lights.push_back({.kind = LightKind::point,
                          .position = {0, 0, 2},
                          .intensity = {4 * M_PI, 4 * M_PI, 4 * M_PI}});
  LitPicture picture;
  picture.samples = 256;
  const Vec3d mean = mean_colour(render_lit(scene, picture).image);
  EXPECT_NEAR(mean.x, 0.5 * std::pow(0.9, 2 + 5), 2e-3);
  EXPECT_NEAR(mean.y, 0.5 * std::pow(0.8, 2 + 5), 2e-3);
  EXPECT_NEAR(mean.z, 0.5, 2e-3);
}

TEST(LightTransport, InsidesAreLeftInAnyOrderAndForgetTheOutermost) {
  const auto id = [](std::uint32_t i) { return static_cast<MaterialId>(i); };
  Insides insides;
  insides.leave(id(7));
  EXPECT_EQ(insides.innermost(), kVacuum);
  for (std::uint32_t i = 1; i <= 5; ++i) insides.enter(id(i));
  insides.leave(id(4));
  insides.leave(id(1));  // forgotten
  EXPECT_EQ(insides.innermost(), id(5));
  insides.leave(id(5));
  EXPECT_EQ(insides.innermost(), id(3));
  insides.leave(id(3));
  insides.leave(id(2));
  EXPECT_EQ(insides.innermost(), kVacuum);
}

TEST(LightTransport, TheClampReportsWhatItTook) {
  Scene scene = empty_lit_scene(1, 0.5);
  LayeredMaterial walls;
  walls.base_colour = {0.5f, 0.5f, 0.5f};
  walls.specular = 0;
  walls.emission = {1, 1, 1};
  scene.add_sphere({{0, 0, 0}, 2}, add_layered(scene, walls));
  LitPicture picture;
  picture.max_scatterings = 60;
  const RenderResult whole = render_lit(scene, picture);
  EXPECT_EQ(whole.clamped_radiance, 0);
  picture.clamp_indirect = 0.1f;
  const RenderResult cut = render_lit(scene, picture);
  EXPECT_LT(mean_of(cut.image), mean_of(whole.image) - 0.01);
  EXPECT_NEAR(mean_of(cut.image) + cut.clamped_radiance, mean_of(whole.image), 1e-4);
}

}  // namespace
}  // namespace dapple::test
