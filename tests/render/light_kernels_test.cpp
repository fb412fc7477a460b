// The vector kernels of light paths against the scalar definitions that they follow: the same
// numbers, on every instruction set. Where paths start, what chance says and the environment.
#include "render/kernels/light_kernels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <set>

#include "render/path_sampler.h"
#include "render/prepared_scene.h"
#include "tests/render/light_kernel_cases.h"

namespace dapple::test {
namespace {

TEST(LightKernels, TheForcedLevelIsTheOneInUse) {
  std::set<const void*> functions;
  on_every_isa([&](const LightKernels& kernels) {
    EXPECT_EQ(kernels.isa, dapple::kernels().isa);
    functions.insert(reinterpret_cast<const void*>(kernels.shade));
  });
  EXPECT_EQ(functions.size(), available_isas().size());
}

TEST(LightKernels, DrawTheSamplersNumbers) {
  Chance chance(1);
  const auto chunk = std::make_unique<VertexChunk>();
  for (const int samples : {1, 3, 16, 1000, 1 << 20}) {
    const PathSampler sampler(samples, 0x123456789abcdefu);
    for (std::size_t i = 0; i < kChunk; ++i) {
      const auto place = sampler.place(chance.below(5000), chance.below(5000),
                                       chance.below(static_cast<std::uint32_t>(samples)));
      chunk->block[i] = place.block;
      chunk->position[i] = place.reversed_position;
      chunk->dimension[i] = chance.below(100);
    }
    on_every_isa([&](const LightKernels& kernels) {
      kernels.draw(sampler.view(), kChunk, *chunk);
      for (std::size_t i = 0; i < kChunk; ++i) {
        const PathSampler::Place place{chunk->block[i], chunk->position[i]};
        const auto choose = sampler.uniform4(place, chunk->dimension[i]);
        const auto move = sampler.uniform4(place, chunk->dimension[i] + 1);
        for (std::size_t k = 0; k < 4; ++k) {
          ASSERT_EQ(chunk->choose[k][i], choose[k]) << i << " " << k;
          ASSERT_EQ(chunk->move[k][i], move[k]) << i << " " << k;
        }
      }
    });
  }
}

TEST(LightKernels, StartTheCamerasRays) {
  Chance chance(2);
  const auto chunk = std::make_unique<StartChunk>();
  for (const FilterKind filter_kind : {FilterKind::box, FilterKind::blackman_harris}) {
    for (const double height : {0.0, 3.0}) {
      RenderSettings settings;
      settings.width = 2000, settings.height = 1000, settings.samples_per_pixel = 64;
      Camera view;
      view.orthographic_height = height;
      view.aperture = 0.3;
      const auto camera = CameraRays::create(view, settings);
      ASSERT_TRUE(camera);
      const PathSampler sampler(64, 5);
      const PixelFilter filter(filter_kind);
      for (std::size_t i = 0; i < kChunk; ++i) {
        chunk->x[i] = chance.below(2000), chunk->y[i] = chance.below(1000);
        chunk->sample[i] = chance.below(64);
      }
      on_every_isa([&](const LightKernels& kernels) {
        kernels.start(sampler.view(), filter.view(), camera->frame(), kChunk, *chunk);
        for (std::size_t i = 0; i < kChunk; ++i) {
          const auto place = sampler.place(chunk->x[i], chunk->y[i], chunk->sample[i]);
          ASSERT_EQ(chunk->block[i], place.block);
          ASSERT_EQ(chunk->position[i], place.reversed_position);
          auto u = sampler.uniform4(place, 0);
          u[0] = filter.place(u[0]), u[1] = filter.place(u[1]);
          const Ray ray =
              camera->generate(static_cast<int>(chunk->x[i]), static_cast<int>(chunk->y[i]), u);
          const Vec3f direction = normalize(ray.direction);
          for (int axis = 0; axis < 3; ++axis) {
            ASSERT_EQ(chunk->origin[axis][i], ray.origin[axis]) << i;
            ASSERT_EQ(chunk->direction[axis][i], direction[axis]) << i;
          }
          ASSERT_LT(chunk->channel[i], 3u);
        }
      });
    }
  }
}

// A picture of noise with black and very bright texels; RGBE holds it without loss, or not.
Scene noisy_surroundings(Chance& chance, bool rgbe, std::uint32_t width, std::uint32_t height) {
  Scene scene;
  scene.environment = {EnvironmentKind::image, ImageId{0}, chance.colour(),
                       chance.between(-500, 500)};
  scene.images.push_back({width, height, TexelFormat::rgb32f, 0, 0});
  scene.texels.resize(scene.images[0].bytes());
  for (std::size_t i = 0; i < std::size_t{width} * height; ++i) {
    const float scale = chance.once_in(9) ? 0.0f : chance.once_in(50) ? 1024.0f : 0x1p-7f;
    Vec3f value = scale * chance.colour();
    if (rgbe) {
      const auto step = [&] { return static_cast<float>(chance.below(256)); };
      value = scale * Vec3f(step(), step(), step());
    }
    std::memcpy(scene.texels.data() + 12 * i, &value, 12);
  }
  return scene;
}

TEST(LightKernels, LookTheEnvironmentUp) {
  Chance chance(3);
  const auto vertices = std::make_unique<VertexChunk>();
  const auto escapes = std::make_unique<EscapeChunk>();
  for (int round = 0; round < 12; ++round) {
    const bool rgbe = round % 2 == 0;
    const Scene scene =
        noisy_surroundings(chance, rgbe, 1 + chance.below(1500), 1 + chance.below(600));
    const EnvironmentLight light(scene, TextureSet(scene));
    const auto view = light.view();
    ASSERT_TRUE(view);
    EXPECT_EQ(view->rgbe != nullptr, rgbe);
    for (std::size_t i = 0; i < kChunk; ++i) {
      vertices->move[2][i] = chance.unit(), vertices->move[3][i] = chance.unit();
      const Vec3f d =
          i < 6 ? Vec3f(i == 0, (i == 1) - (i == 2), (i == 3) - (i == 4)) : chance.direction();
      for (int axis = 0; axis < 3; ++axis) escapes->direction[axis][i] = d[axis];
    }
    on_every_isa([&](const LightKernels& kernels) {
      kernels.sample_environment(*view, kChunk, *vertices);
      kernels.see_environment(*view, kChunk, *escapes);
      for (std::size_t i = 0; i < kChunk; ++i) {
        const EnvironmentSample s = light.sample({vertices->move[2][i], vertices->move[3][i]});
        ASSERT_EQ(vector_at(vertices->light_direction, i), s.direction) << i;
        ASSERT_EQ(vector_at(vertices->light_radiance, i), s.radiance) << i;
        ASSERT_EQ(vertices->light_pdf[i], s.pdf) << i;
        const Vec3f d = vector_at(escapes->direction, i);
        ASSERT_EQ(vector_at(escapes->radiance, i), light.radiance(d)) << i;
        ASSERT_EQ(escapes->pdf[i], light.pdf(d)) << i;
      }
    });
  }
}

// Whatever went wrong before: nothing beyond the picture is read.
TEST(LightKernels, DirectionsThatAreNotNumbersStayWithinTheEnvironment) {
  Chance chance(4);
  const float none = std::numeric_limits<float>::quiet_NaN(), infinite = HUGE_VALF;
  const auto escapes = std::make_unique<EscapeChunk>();
  for (const bool rgbe : {false, true}) {
    const Scene scene = noisy_surroundings(chance, rgbe, 30, 20);
    const EnvironmentLight light(scene, TextureSet(scene));
    const auto view = light.view();
    ASSERT_TRUE(view);
    const Vec3f bad[] = {{none, none, none}, {none, 0.5f, 0.5f}, {0.5f, none, 0.5f},
                         {0.5f, 0.5f, none}, {infinite, 0, 0},   {0, infinite, 0},
                         {0, 0, -infinite},  {0, 0, 0},          {1e30f, 1e30f, 1e30f},
                         {1e-40f, 1e-40f, 0}};
    for (const Vec3f& d : bad) {
      light.radiance(d), light.pdf(d);
      for (std::size_t i = 0; i < kChunk; ++i) {
        for (int axis = 0; axis < 3; ++axis) escapes->direction[axis][i] = d[axis];
      }
      on_every_isa(
          [&](const LightKernels& kernels) { kernels.see_environment(*view, kChunk, *escapes); });
    }
  }
}

TEST(LightKernels, AnyFiniteRotationGivesATurnWithinOne) {
  Chance chance(5);
  Scene scene = noisy_surroundings(chance, false, 30, 20);
  for (const float degrees : {0.0f, -359.0f, 360.0f, 1e30f, -3.4e38f}) {
    scene.environment.rotation = degrees;
    const EnvironmentLight light(scene, TextureSet(scene));
    const auto view = light.view();
    ASSERT_TRUE(view);
    EXPECT_LT(std::fabs(view->turn), 1.0f) << degrees;
  }
}

}  // namespace
}  // namespace dapple::test
