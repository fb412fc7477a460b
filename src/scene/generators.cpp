#include "scene/generators.h"

#include "math/functions.h"
#include "math/random.h"

namespace dapple {
namespace {

Camera classic_camera(const Vec3d& look_from, const Vec3d& look_at) {
  Camera camera;
  camera.look_from = look_from;
  camera.look_at = look_at;
  return camera;
}

// A wall of side x side spheres of radius 3, 6 apart, spread over the two coordinates that
// `place` fills.
template <class Place>
void add_wall(Scene& scene, std::int64_t side, const Material& material, Place place) {
  const MaterialId id = scene.add_material(material);
  for (std::int64_t i = 0; i < side; ++i) {
    for (std::int64_t j = 0; j < side; ++j) {
      const double a = -30.0 + 6.0 * static_cast<double>(i);
      const double b = -30.0 + 6.0 * static_cast<double>(j);
      scene.add_sphere({place(a, b), 3.0}, id);
    }
  }
}

}  // namespace

Scene make_empty(std::int64_t) {
  Scene scene;
  scene.camera = classic_camera({0, 2, 3}, {0, 0, 0});
  return scene;
}

Scene make_nice(std::int64_t) {
  Scene scene;
  scene.camera = classic_camera({0, 3, 3}, {0, 0, 0});
  const MaterialId red = scene.add_material(Metal{{1, 0, 0}, 0.9});
  const MaterialId green = scene.add_material(Metal{{0, 1, 0}, 0.9});
  const MaterialId grey = scene.add_material(Lambertian{{0.8, 0.8, 0.8}});
  const MaterialId blue = scene.add_material(Metal{{0, 0, 1}, 0.9});
  scene.add_rectangle(ShapeKind::yz_rectangle, {-5, 0, -5, 5, -4}, red);
  scene.add_rectangle(ShapeKind::yz_rectangle, {-5, 0, -5, 5, 4}, green);
  scene.add_sphere({{4, 0, -6}, 2}, grey);
  scene.add_rectangle(ShapeKind::xy_rectangle, {-4, 4, -5, 0, -5}, blue);
  return scene;
}

Scene make_irreg(std::int64_t side) {
  Scene scene;
  scene.camera = classic_camera({0, 12, 30}, {0, 10, -1});
  const MaterialId mirror = scene.add_material(Metal{{1, 1, 1}, 0});
  for (std::int64_t i = 0; i < side; ++i) {
    for (std::int64_t j = 0; j < side; ++j) {
      const double x = -300.0 + 12.0 * static_cast<double>(i);
      const double z = -300.0 + 12.0 * static_cast<double>(j);
      scene.add_sphere({{x, 0, z}, 6}, mirror);
    }
  }
  return scene;
}

Scene make_rgbbox(std::int64_t side) {
  Scene scene;
  scene.camera = classic_camera({0, 30, 30}, {0, -1, -1});
  add_wall(scene, side, Metal{{1, 0, 0}, 0.1}, [](double a, double b) { return Vec3d(-30, a, b); });
  add_wall(scene, side, Metal{{0, 1, 0}, 0.1}, [](double a, double b) { return Vec3d(a, b, -30); });
  add_wall(scene, side, Metal{{0, 0, 1}, 0.1}, [](double a, double b) { return Vec3d(30, a, b); });
  add_wall(scene, side, Metal{{1, 1, 1}, 0.0}, [](double a, double b) { return Vec3d(a, -30, b); });
  return scene;
}

// Centres uniform in the cube [-100, 100]^3, radii 0.1 to 0.4 of the mean spacing, 64 materials:
// mostly matt, some metal. Seen from outside, over one edge.
Scene make_sphere_cloud(std::int64_t count) {
  constexpr std::uint64_t kSeed = 0x64617070'6c650001u;
  constexpr std::uint32_t kMaterialCount = 64;
  Scene scene;
  scene.camera = classic_camera({0, 90, 230}, {0, -5, 0});
  for (std::uint32_t i = 0; i < kMaterialCount; ++i) {
    const auto u = uniform4(i, 0, 0, 1, kSeed);
    const Vec3d albedo(0.25 + 0.65 * double{u[0]}, 0.25 + 0.65 * double{u[1]},
                       0.25 + 0.65 * double{u[2]});
    if (i % 8 == 7) {
      scene.add_material(Metal{albedo, 0.3 * double{u[3]}});
    } else {
      scene.add_material(Lambertian{albedo});
    }
  }
  const double spacing = 200.0 / cube_root(static_cast<double>(count));
  scene.spheres.reserve(static_cast<std::size_t>(count));
  scene.sphere_materials.reserve(static_cast<std::size_t>(count));
  for (std::int64_t i = 0; i < count; ++i) {
    const auto id = static_cast<std::uint32_t>(i);
    const auto u = uniform4(id, 0, 0, 0, kSeed);
    const Vec3d centre(200 * double{u[0]} - 100, 200 * double{u[1]} - 100,
                       200 * double{u[2]} - 100);
    const auto material =
        static_cast<MaterialId>(philox4x32({id, 0, 0, 2}, kSeed)[0] % kMaterialCount);
    scene.add_sphere({centre, spacing * (0.1 + 0.3 * double{u[3]})}, material);
  }
  return scene;
}

}  // namespace dapple
