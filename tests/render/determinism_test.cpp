// The same picture, to the bit, for any number of threads, structure, instruction set and order
// of the work.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "accel/kernels/dispatch.h"
#include "parallel/parallel.h"
#include "render/camera_rays.h"
#include "render/classic_paths.h"
#include "render/render_job.h"
#include "scene/named_scenes.h"
#include "tests/scenes/meshes.h"
#include "tests/scenes/picture_scenes.h"

namespace dapple::test {
namespace {

RenderSettings small_picture() {
  RenderSettings settings;
  settings.width = 70;  // tiles of different sizes at the edges
  settings.height = 45;
  settings.samples_per_pixel = 6;
  settings.seed = 3;
  return settings;
}

std::vector<PictureScene> scenes() {
  std::vector<PictureScene> result = picture_scenes();
  for (const char* name : {"nice", "irreg:20", "rgbbox", "empty"}) {
    result.push_back({name, make_named_scene(name).value()});
  }
  return result;
}

Image picture(const Scene& scene, AccelKind kind, const RenderSettings& settings,
              LeafForm form = LeafForm::whole) {
  const PreparedScene prepared(scene, make_accel(kind, scene, BvhQuality::medium, form));
  auto result = render(prepared, settings);
  EXPECT_TRUE(result);
  EXPECT_EQ(result->dropped_samples, 0u);
  return std::move(result->image);
}

TEST(Determinism, ThreadsStructuresAndInstructionSetsMakeNoDifference) {
  for (const PictureScene& scene : scenes()) {
    set_thread_count(1);
    const Image expected = picture(scene.scene, AccelKind::linear, small_picture());
    for (const int threads : {1, 2, 3, 7}) {
      set_thread_count(threads);
      for (const AccelKind kind : {AccelKind::linear, AccelKind::median, AccelKind::fast}) {
        const Image image = picture(scene.scene, kind, small_picture());
        EXPECT_EQ(image.pixels, expected.pixels)
            << scene.name << ", " << accel_name(kind) << ", " << threads << " threads";
      }
    }
    for (const std::string_view isa : available_isas()) {
      ASSERT_TRUE(force_isa(isa));
      EXPECT_EQ(picture(scene.scene, AccelKind::fast, small_picture()).pixels, expected.pixels)
          << scene.name << ", " << isa;
    }
    ASSERT_TRUE(force_isa(available_isas().front()));
    set_thread_count(0);
  }
}

TEST(Determinism, OtherSeedsGiveOtherPictures) {
  const Scene scene = make_named_scene("nice").value();
  RenderSettings settings = small_picture();
  const Image first = picture(scene, AccelKind::fast, settings);
  settings.seed += 1;
  EXPECT_NE(picture(scene, AccelKind::fast, settings).pixels, first.pixels);
}

struct Piece {
  Tile tile;
  SampleRange samples;
};

// Cuts the picture at random columns, rows and samples.
std::vector<Piece> random_pieces(const RenderSettings& s, std::mt19937_64& random) {
  const auto cuts = [&](int end) {
    std::vector<int> at = {0, end};
    for (int i = 0; i < 3; ++i) at.push_back(static_cast<int>(random() % std::uint64_t(end)));
    std::sort(at.begin(), at.end());
    return at;
  };
  const auto xs = cuts(s.width), ys = cuts(s.height), samples = cuts(s.samples_per_pixel);
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
    for (std::size_t j = 0; j + 1 < ys.size(); ++j) {
      for (std::size_t k = 0; k + 1 < samples.size(); ++k) {
        pieces.push_back({{xs[i], ys[j], xs[i + 1], ys[j + 1]}, {samples[k], samples[k + 1]}});
      }
    }
  }
  std::shuffle(pieces.begin(), pieces.end(), random);
  return pieces;
}

TEST(Determinism, AnyCutIntoPiecesInAnyOrderGivesThePicture) {
  std::mt19937_64 random(5);
  for (const PictureScene& scene : scenes()) {
    const RenderSettings settings = small_picture();
    const PreparedScene prepared(scene.scene, make_accel(AccelKind::fast, scene.scene));
    const auto expected = render(prepared, settings);
    const auto camera = CameraRays::create(scene.scene.camera, settings);
    ASSERT_TRUE(expected && camera);
    const ClassicPaths paths(prepared, *camera, settings);
    for (int repeat = 0; repeat < 3; ++repeat) {
      Film film(settings.width, settings.height);
      for (const Piece& piece : random_pieces(settings, random)) {
        TileOutput output{TileSums(piece.tile), std::nullopt};
        paths.render(piece.samples, output);
        film.merge(output.colour);
      }
      EXPECT_EQ(film.to_image(settings.samples_per_pixel).pixels, expected->image.pixels)
          << scene.name;
    }
  }
}

// Everything that the transport of models decides by random numbers: lights of all kinds, glass
// with an absorbing and scattering inside, veils, rough metal.
Scene lit_scene() {
  Scene scene = make_named_scene("nice").value();
  const auto add = [&](const LayeredMaterial& material) {
    scene.layered_materials.push_back(material);
    return scene.add_material(
        Layered{static_cast<std::uint32_t>(scene.layered_materials.size() - 1)});
  };
  LayeredMaterial glass, veil, metal, lamp;
  glass.transmission = 1;
  glass.roughness = 0.2f;
  glass.thickness = 1;
  glass.attenuation_distance = 1;
  glass.attenuation_colour = {0.3f, 0.9f, 0.5f};
  glass.scattering = {0.2f, 0.1f, 0.3f};
  veil.alpha = 0.4f;
  veil.alpha_mode = AlphaMode::blend;
  metal.metallic = 1;
  metal.roughness = 0.3f;
  metal.clearcoat = 0.5f;
  metal.anisotropy = 0.5f;
  lamp.emission = {4, 3, 2};
  scene.add_sphere({{-1, -1, -3}, 1.5}, add(glass));
  scene.add_sphere({{2, -2, -2}, 1}, add(metal));
  scene.add_sphere({{0, 3, -4}, 0.5}, add(lamp));
  scene.add_rectangle(ShapeKind::xy_rectangle, {-2, 1, -3, 0, -1}, add(veil));
  scene.lights.push_back({LightKind::point, {0, 2, 0}, {0, 0, -1}, {3, 3, 3}, 0, 0});
  scene.environment.kind = EnvironmentKind::studio;
  return scene;
}

TEST(Determinism, PicturesOfModelsToo) {
  const Scene scene = lit_scene();
  set_thread_count(1);
  const Image expected = picture(scene, AccelKind::linear, small_picture());
  for (const int threads : {2, 3, 7}) {
    set_thread_count(threads);
    EXPECT_EQ(picture(scene, AccelKind::fast, small_picture()).pixels, expected.pixels) << threads;
  }
  for (const std::string_view isa : available_isas()) {
    ASSERT_TRUE(force_isa(isa));
    EXPECT_EQ(picture(scene, AccelKind::fast, small_picture()).pixels, expected.pixels) << isa;
  }
  ASSERT_TRUE(force_isa(available_isas().front()));
  set_thread_count(0);
}

TEST(Determinism, CompactLeavesMakeNoDifference) {
  const Scene lit = lit_scene(), classic = make_named_scene("nice").value();
  for (Scene scene : {lit, classic}) {
    const MaterialId material = scene.add_material(Lambertian{{0.7f, 0.5f, 0.3f}});
    add_cube_mesh({{0, -2, -3}, 1.5f, 12, 1, 0.2f}, material, scene);
    add_cube_mesh({{1, 2, -5}, 1, 1, 0, 0}, material, scene);
    const Image expected = picture(scene, AccelKind::linear, small_picture());
    for (const std::string_view isa : available_isas()) {
      ASSERT_TRUE(force_isa(isa));
      const Image image = picture(scene, AccelKind::fast, small_picture(), LeafForm::compact);
      EXPECT_EQ(image.pixels, expected.pixels) << isa;
    }
    ASSERT_TRUE(force_isa(available_isas().front()));
  }
}

// A picture of more samples begins with those of a smaller one: what was rendered once can be
// continued.
TEST(Determinism, MoreSamplesContinueThePicture) {
  const Scene scene = make_named_scene("nice").value();
  const PreparedScene prepared(scene, make_accel(AccelKind::fast, scene));
  RenderSettings few = small_picture(), many = small_picture();
  few.samples_per_pixel = 4;
  many.samples_per_pixel = 9;
  const auto camera = CameraRays::create(scene.camera, few);
  Film film(few.width, few.height);
  TileOutput first{TileSums(Tile{0, 0, few.width, few.height}), std::nullopt}, rest = first;
  ClassicPaths(prepared, *camera, few).render({0, 4}, first);
  ClassicPaths(prepared, *camera, many).render({4, 9}, rest);
  film.merge(first.colour);
  EXPECT_EQ(film.to_image(4).pixels, picture(scene, AccelKind::fast, few).pixels);
  film.merge(rest.colour);
  EXPECT_EQ(film.to_image(9).pixels, picture(scene, AccelKind::fast, many).pixels);
}

}  // namespace
}  // namespace dapple::test
