#include "shading/material_evaluator.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/fast_functions.h"
#include "math/random.h"
#include "math/warps.h"
#include "tests/shading/lit_room.h"
#include "tests/shading/surface_cases.h"

namespace dapple::test {
namespace {

// One layered material and the point (0, 0, 0) of a surface that faces up.
class OneMaterial {
 public:
  OneMaterial() { id_ = room_.add_glow({}); }
  LayeredMaterial& layered() { return room_.scene.layered_materials[0]; }
  Scene& scene() { return room_.scene; }

  template <class Use>
  auto with(Use use) {
    const TextureSet textures(room_.scene);
    return use(MaterialEvaluator(room_.scene, textures), id_);
  }
  // The texture of one texel.
  void paint(MapUse use, std::array<std::uint8_t, 4> texel) {
    const auto id = static_cast<std::uint32_t>(room_.scene.images.size());
    room_.scene.images.push_back({1, 1, TexelFormat::rgba8, 0, room_.scene.texels.size()});
    room_.scene.texels.insert(room_.scene.texels.end(), texel.begin(), texel.end());
    room_.scene.texels.resize((room_.scene.texels.size() + 15) / 16 * 16);
    room_.scene.textures.push_back({.image = ImageId{id}});
    layered().map(use).texture = TextureId{id};
  }

 private:
  LitRoom room_;
  MaterialId id_;
};

TEST(MaterialEvaluator, AlphaModes) {
  OneMaterial one;
  SurfaceInteraction at;
  at.colour.w = 0.5f;
  one.layered().alpha = 0.6f;
  const auto opacity = [&] {
    return one.with([&](const auto& m, MaterialId id) { return m.opacity(id, at); });
  };
  EXPECT_EQ(opacity(), 1);
  one.layered().alpha_mode = AlphaMode::blend;
  EXPECT_NEAR(opacity(), 0.3, 1e-6);
  one.layered().alpha_mode = AlphaMode::mask;
  EXPECT_EQ(opacity(), 0);
  one.layered().alpha_cutoff = 0.3f;
  EXPECT_EQ(opacity(), 1);
}

TEST(MaterialEvaluator, EmissionIsFactorTimesTexture) {
  OneMaterial one;
  one.layered().emission = {2, 4, 8};
  one.paint(MapUse::emissive, {255, 0, 255, 255});
  EXPECT_EQ(one.with([](const auto& m, MaterialId id) { return m.emission(id, {}); }),
            Vec3f(2, 0, 8));
}

// After the attenuation distance the attenuation colour is left.
TEST(MaterialEvaluator, InteriorAttenuatesAsAsked) {
  OneMaterial one;
  one.layered().transmission = 1;
  one.layered().thickness = 1;
  one.layered().attenuation_distance = 0.4f;
  one.layered().attenuation_colour = {0.2f, 0.5f, 1};
  const Medium medium = one.with([](const auto& m, MaterialId id) { return m.interior(id); });
  const Vec3f left = transmittance(medium, 0.4f);
  EXPECT_NEAR(left.x, 0.2, 1e-5);
  EXPECT_NEAR(left.y, 0.5, 1e-5);
  EXPECT_NEAR(left.z, 1, 1e-5);
  one.layered().thickness = 0;
  EXPECT_FALSE(one.with([](const auto& m, MaterialId id) { return m.has_interior(id); }));
}

// Whatever the map says and wherever one looks from, a white mirror reflects most light, and to
// its outer side.
TEST(MaterialEvaluator, NormalMapsNeitherBlackenNorLeak) {
  OneMaterial one;
  one.layered().metallic = 1;
  one.layered().roughness = 0;
  for (const std::array<std::uint8_t, 4>& texel :
       {std::array<std::uint8_t, 4>{128, 128, 255, 0}, {255, 128, 128, 0}, {10, 250, 160, 0}}) {
    one.paint(MapUse::normal, texel);
    for (const float cosine : {0.02f, 0.3f, 0.9f}) {
      for (const float turns : {0.0f, 0.2f, 0.6f}) {
        const Vec3f wo = direction_at(cosine, turns);
        const Bsdf bsdf = one.with([&](const auto& m, MaterialId id) {
          return m.make_bsdf(id, SurfaceInteraction{}, wo);
        });
        const auto sample = bsdf.sample(0.5f, {0.5f, 0.5f});
        ASSERT_TRUE(sample);
        EXPECT_GT(sample->wi.z, 0);
        EXPECT_GT(sample->weight.y, 0.9f);
      }
    }
  }
}

TEST(MaterialEvaluator, NormalMapsTurnTheMirror) {
  OneMaterial one;
  one.layered().metallic = 1;
  one.layered().roughness = 0;
  one.paint(MapUse::normal, {192, 128, 239, 0});  // about (0.5, 0, 0.87)
  const Bsdf bsdf = one.with([](const auto& m, MaterialId id) {
    return m.make_bsdf(id, SurfaceInteraction{}, {0, 0, 1});
  });
  const auto sample = bsdf.sample(0.5f, {0.5f, 0.5f});
  ASSERT_TRUE(sample);
  EXPECT_NEAR(sample->wi.x, std::sin(2 * std::asin(0.5)), 0.02);
}

// A flat pane lets light straight through; a solid bends it by Snell's law.
TEST(MaterialEvaluator, RefractsBySnellsLaw) {
  OneMaterial one;
  one.layered().transmission = 1;
  one.layered().roughness = 0;
  const Vec3f wo = direction_at(0.6f, 0);
  const auto transmitted = [&](bool outside) {
    SurfaceInteraction at;
    at.from_outside = outside;
    if (!outside) at.geometric_normal = at.shading_normal = {0, 0, -1};
    const Bsdf bsdf =
        one.with([&](const auto& m, MaterialId id) { return m.make_bsdf(id, at, wo); });
    return bsdf.sample(0.999f, {0.5f, 0.5f});
  };
  EXPECT_NEAR(transmitted(true)->wi.x, -0.8, 1e-5);
  one.layered().thickness = 1;
  EXPECT_NEAR(transmitted(true)->wi.x, -0.8 / 1.5, 1e-5);
  one.layered().ior = 1.2f;
  EXPECT_NEAR(transmitted(false)->wi.x, -0.8 * 1.2, 1e-5);
}

// Dispersion bends blue more than red; each channel by itself, and all together white.
TEST(MaterialEvaluator, DispersionSplitsChannels) {
  OneMaterial one;
  one.layered().transmission = 1;
  one.layered().roughness = 0;
  one.layered().thickness = 1;
  one.layered().dispersion = 2;
  const Vec3f wo = direction_at(0.6f, 0);
  Vec3f sum;
  float x[3];
  for (int c = 0; c < 3; ++c) {
    const Bsdf bsdf = one.with([&](const auto& m, MaterialId id) {
      return m.make_bsdf(id, SurfaceInteraction{}, wo, {c, false});
    });
    const auto sample = bsdf.sample(0.999f, {0.5f, 0.5f});
    ASSERT_TRUE(sample && sample->transmitted && sample->one_channel);
    x[c] = -sample->wi.x;
    for (int other = 0; other < 3; ++other) {
      if (other != c) {
        EXPECT_EQ(sample->weight[other], 0);
      }
    }
    EXPECT_GT(sample->weight[c], 2.5f);
  }
  EXPECT_GT(x[0], x[1]);
  EXPECT_GT(x[1], x[2]);
}

// Within one layer light goes both ways alike. (Layers take from those below by the way to wo.)
TEST(Bsdf, AMetalReflectsBothWaysAlike) {
  SurfaceCase surface{"metal", white_point(0.5f)};
  surface.point.metallic = 1;
  // Nothing at normal incidence: the compensation for multiple scattering, which goes by wo alone,
  // is not there either.
  surface.point.base_colour = {0, 0, 0};
  for (std::uint32_t i = 0; i < 100; ++i) {
    const auto u = uniform4(i, 0, 0, 0, 13);
    const Vec3f a = direction_at(0.1f + 0.9f * u[0], u[1]),
                b = direction_at(0.1f + 0.9f * u[2], u[3]);
    const float there = bsdf_of(surface, a).evaluate(b).f.x / b.z;
    const float back = bsdf_of(surface, b).evaluate(a).f.x / a.z;
    EXPECT_NEAR(there, back, 1e-3f * back);
  }
}

}  // namespace
}  // namespace dapple::test
