// The vector kernels against the scalar definitions that they follow: the same sums, to the bit,
// path by path.
#include "render/kernels/path_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <stdexcept>
#include <string>

#include "accel/kernels/dispatch.h"
#include "math/random.h"
#include "render/classic_paths.h"
#include "scene/named_scenes.h"
#include "shading/scatter.h"
#include "tests/scenes/picture_scenes.h"

namespace dapple::test {
namespace {

// One path after the other, from the scalar functions alone.
class ScalarPaths {
 public:
  ScalarPaths(const PreparedScene& scene, const CameraRays& camera, const RenderSettings& settings)
      : scene_(scene), camera_(camera), settings_(settings) {}

  void render(SampleRange samples, TileSums& sums) const {
    std::size_t pixel = 0;
    for (int y = sums.tile().y0; y < sums.tile().y1; ++y) {
      for (int x = sums.tile().x0; x < sums.tile().x1; ++x, ++pixel) {
        for (int sample = samples.begin; sample < samples.end; ++sample) {
          if (const auto radiance = trace(x, y, sample)) sums.add(pixel, *radiance);
        }
      }
    }
  }

 private:
  std::array<float, 4> random(int x, int y, int sample, std::uint32_t dimension) const {
    return uniform4(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                    static_cast<std::uint32_t>(sample), dimension, settings_.seed);
  }

  // No value for a path that was absorbed.
  std::optional<Vec3f> trace(int x, int y, int sample) const {
    Vec3f throughput{1, 1, 1};
    Ray ray = camera_.generate(x, y, random(x, y, sample, kCameraDimension));
    for (int scatterings = 0; scatterings < settings_.max_scatterings; ++scatterings) {
      const Hit hit = scene_.accel().intersect(ray);
      if (!hit.found()) return throughput * sky(ray.direction);
      const SurfacePoint at = scene_.accel().locate(ray, hit);
      const bool from_outside = dot(ray.direction, at.outward) < 0.0f;
      const Vec3f normal = from_outside ? at.outward : -at.outward;
      const auto scattered =
          scatter(scene_.material_of(hit), {normalize(ray.direction), normal, from_outside},
                  random(x, y, sample, scattering_dimension(scatterings)));
      if (!scattered) return std::nullopt;
      throughput = throughput * scattered->attenuation;
      const float side = dot(scattered->direction, normal) >= 0.0f ? at.error : -at.error;
      ray.origin = at.position + side * normal;
      ray.direction = scattered->direction;
    }
    return throughput;
  }

  const PreparedScene& scene_;
  const CameraRays& camera_;
  const RenderSettings& settings_;
};

Material random_material(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit;
  const Vec3d albedo = {unit(random), unit(random), unit(random)};
  switch (random() % 5) {
    case 0:
      return Lambertian{albedo};
    case 1:
      return Metal{albedo, 0};
    case 2:
      return Metal{albedo, 2 * unit(random)};
    case 3:
      return Dielectric{1 + unit(random)};
    default:
      return Dielectric{1 / (1 + unit(random))};
  }
}

// Shapes of all kinds around the origin, seen from among them.
Scene random_scene(std::mt19937_64& random, int object_count, int material_count) {
  std::uniform_real_distribution<double> around(-10, 10), size(0.1, 3);
  Scene scene;
  scene.camera.look_from = {around(random), around(random), around(random)};
  scene.camera.aperture = 0.3;
  std::vector<MaterialId> materials;
  for (int i = 0; i < material_count; ++i) {
    materials.push_back(scene.add_material(random_material(random)));
  }
  for (int i = 0; i < object_count; ++i) {
    const Vec3d at = {around(random), around(random), around(random)};
    const double r = size(random);
    const MaterialId material = materials[random() % materials.size()];
    const auto kind = static_cast<ShapeKind>(random() % (3 + kRectangleKindCount));
    if (kind == ShapeKind::sphere) {
      scene.add_sphere({at, random() % 4 == 0 ? -r : r}, material);
    } else if (kind == ShapeKind::triangle) {
      Triangle triangle;
      for (std::uint32_t& vertex : triangle.vertices) {
        vertex = static_cast<std::uint32_t>(scene.vertices.positions.size());
        const Vec3d corner = {at.x + size(random), at.y - size(random), at.z + size(random)};
        scene.vertices.positions.push_back(Vec3f(corner));
      }
      scene.add_triangle(triangle, material);
    } else if (kind == ShapeKind::cylinder) {
      scene.add_cylinder({at, {at.x + r, at.y, at.z - r}, 0.3 * r}, material);
    } else {
      scene.add_rectangle(kind, {at.x - r, at.x + r, at.y - r, at.y + r, at.z}, material);
    }
  }
  if (object_count > 10) {
    scene.vertices.positions.insert(scene.vertices.positions.end(),
                                    {{0, 0, 0}, {2, 0, 0}, {0, 2, 1}, {-1, 0.5f, 2}});
    const auto first = static_cast<std::uint32_t>(scene.vertices.positions.size() - 4);
    const Triangle triangles[] = {{{first, first + 1, first + 2}}, {{first, first + 2, first + 3}}};
    const MaterialId of_triangles[] = {materials.front(), materials.back()};
    Instance instance;
    instance.prototype = scene.add_prototype(triangles, of_triangles);
    for (int i = 0; i < object_count / 4; ++i) {
      for (auto& row : instance.to_world.rows) {
        for (float& number : row) number = static_cast<float>(around(random)) / 10;
        row[3] *= 10;
      }
      scene.add_instance(instance);
    }
  }
  return scene;
}

struct Part {
  Tile tile;
  SampleRange samples = {1, 3};
};

const Part kSmallParts[] = {{{0, 0, 61, 47}}, {{7, 3, 8, 4}}, {{30, 20, 47, 29}}};

// Both ways of rendering some parts, on every instruction set, and with compact leaves.
void expect_scalar_sums(const Scene& scene, const std::string& name,
                        std::span<const Part> parts = kSmallParts) {
  RenderSettings settings;
  settings.width = 61;
  settings.height = 47;
  settings.samples_per_pixel = 3;
  settings.seed = 0x123456789abcdefu;
  const auto prepare = [&](LeafForm form) {
    return PreparedScene(scene, make_accel(AccelKind::fast, scene, BvhQuality::medium, form));
  };
  const PreparedScene prepared = prepare(LeafForm::whole), compact = prepare(LeafForm::compact);
  const auto camera = CameraRays::create(scene.camera, settings);
  ASSERT_TRUE(camera);
  const ScalarPaths scalar(prepared, *camera, settings);
  const ClassicPaths both_paths[] = {{prepared, *camera, settings}, {compact, *camera, settings}};
  for (const Part& part : parts) {
    TileSums expected(part.tile);
    scalar.render(part.samples, expected);
    for (const std::string_view isa : available_isas()) {
      ASSERT_TRUE(force_isa(isa));
      for (const ClassicPaths& paths : both_paths) {
        TileOutput output{TileSums(part.tile), std::nullopt};
        paths.render(part.samples, output);
        const TileSums& sums = output.colour;
        EXPECT_EQ(sums.dropped(), expected.dropped()) << name << ", " << isa;
        EXPECT_EQ(sums.cut_count(), expected.cut_count()) << name << ", " << isa;
        EXPECT_TRUE(std::ranges::equal(sums.sums(), expected.sums())) << name << ", " << isa;
      }
    }
    ASSERT_TRUE(force_isa(available_isas().front()));
  }
}

TEST(PathKernels, TheForcedLevelIsTheOneInUse) {
  std::set<const void*> functions;
  for (const std::string_view isa : available_isas()) {
    ASSERT_TRUE(force_isa(isa));
    EXPECT_EQ(path_kernels().isa, isa);
    functions.insert(reinterpret_cast<const void*>(path_kernels().scatter));
  }
  EXPECT_EQ(functions.size(), available_isas().size());
  ASSERT_TRUE(force_isa(available_isas().front()));
}

TEST(PathKernels, AgreeWithTheScalarDefinitionsOnRandomScenes) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 12; ++i) {
    const Scene scene = random_scene(random, 1 + 20 * i, 1 + static_cast<int>(random() % 40));
    expect_scalar_sums(scene, "random scene " + std::to_string(i));
  }
}

TEST(PathKernels, AgreeWithTheScalarDefinitionsOnKnownScenes) {
  for (const PictureScene& scene : picture_scenes()) expect_scalar_sums(scene.scene, scene.name);
  for (const char* name : {"nice", "irreg:20", "rgbbox", "empty", "spheres:500"}) {
    expect_scalar_sums(make_named_scene(name).value(), name);
  }
}

// As many columns, rows and samples as a path's word can tell apart.
TEST(PathKernels, AgreeWithTheScalarDefinitionsOnTheLargestParts) {
  const Part parts[] = {{{3, 5, 3 + kMostColumns, 7}, {0, 1}},
                        {{3, 5, 5, 5 + kMostRows}, {2, 3}},
                        {{29, 23, 32, 26}, {7, 7 + kMostSamples}},
                        {{0, 0, 128, 64}, {0, 1}}};
  expect_scalar_sums(make_named_scene("nice").value(), "nice", parts);
}

TEST(PathKernels, LargerPartsAreRefused) {
  const Scene scene = make_named_scene("empty").value();
  const RenderSettings settings;
  const PreparedScene prepared(scene, make_accel(AccelKind::fast, scene));
  const auto camera = CameraRays::create(scene.camera, settings);
  ASSERT_TRUE(camera);
  const ClassicPaths paths(prepared, *camera, settings);
  const Part parts[] = {{{0, 0, kMostColumns + 1, 1}, {0, 1}},
                        {{0, 0, 1, kMostRows + 1}, {0, 1}},
                        {{0, 0, 1, 1}, {0, kMostSamples + 1}}};
  for (const Part& part : parts) {
    TileOutput output{TileSums(part.tile), std::nullopt};
    EXPECT_THROW(paths.render(part.samples, output), std::length_error);
  }
}

// Samples beyond what the film's words hold, beyond its clamp, and beyond all floats.
TEST(PathKernels, AgreeWithTheScalarDefinitionsOnBrightAndInfiniteSamples) {
  std::mt19937_64 random(12);
  for (const double albedo : {3.0, 100.0, 1e10, 1e30}) {
    Scene scene = random_scene(random, 100, 20);
    for (std::size_t i = 0; i < scene.materials.size(); i += 2) {
      scene.materials[i] = Lambertian{{albedo, 0.5, 1}};
    }
    expect_scalar_sums(scene, "albedo " + std::to_string(albedo));
  }
}

// Spheres so small that their normals have no digits, and so far that positions have few.
TEST(PathKernels, AgreeWithTheScalarDefinitionsOnTinyAndFarSpheres) {
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const double scale : {1e-22, 1e-15, 1.0, 1e7}) {
    Scene scene;
    scene.camera.look_from = {0, 0, 3 * scale};
    scene.camera.aperture = 0;
    for (int i = 0; i < 50; ++i) {
      const MaterialId material = scene.add_material(random_material(random));
      scene.add_sphere(
          {{scale * unit(random), scale * unit(random), scale * unit(random)}, scale * 0.3},
          material);
    }
    expect_scalar_sums(scene, "scale " + std::to_string(scale));
  }
}

}  // namespace
}  // namespace dapple::test
