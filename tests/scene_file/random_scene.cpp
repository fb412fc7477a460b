#include "tests/scene_file/random_scene.h"

#include <cmath>

#include "math/random.h"

namespace dapple::test {
namespace {

class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : seed_(seed) {}

  std::uint32_t below(std::uint32_t n) { return philox4x32({next_++, 0, 0, 0}, seed_)[0] % n; }
  double unit() { return below(1u << 30) * 0x1p-30; }
  double coordinate() {
    switch (below(8)) {
      case 0:
        return 0.0;
      case 1:
        return -0.0;
      case 2:
        return 5e-324;
      case 3:
        return -1e18;
      case 4:
        return std::ldexp(unit() - 0.5, static_cast<int>(below(110)) - 50);
      default:
        return 200 * unit() - 100;
    }
  }
  Vec3d point() { return {coordinate(), coordinate(), coordinate()}; }
  Vec3d colour() { return {unit(), unit(), unit()}; }

 private:
  std::uint64_t seed_;
  std::uint32_t next_ = 0;
};

Material random_material(Numbers& numbers) {
  switch (numbers.below(3)) {
    case 0:
      return Lambertian{numbers.colour()};
    case 1:
      return Metal{numbers.colour(), numbers.unit()};
    default:
      return Dielectric{1 + numbers.unit()};
  }
}

Camera random_camera(Numbers& numbers) {
  Camera camera;
  camera.look_from = numbers.point();
  camera.look_at = numbers.point();
  camera.up = numbers.point();
  camera.vertical_fov = 1 + 178 * numbers.unit();
  camera.aperture = numbers.unit();
  camera.focus_distance = 0.1 + 100 * numbers.unit();
  return camera;
}

}  // namespace

Scene random_scene(std::uint64_t seed, std::size_t object_count) {
  Numbers numbers(seed);
  Scene scene;
  scene.camera = random_camera(numbers);
  const std::uint32_t material_count = 1 + numbers.below(7);
  for (std::uint32_t i = 0; i < material_count; ++i) scene.add_material(random_material(numbers));
  for (std::size_t i = 0; i < object_count; ++i) {
    const auto material = static_cast<MaterialId>(numbers.below(material_count));
    const auto kind = static_cast<ShapeKind>(numbers.below(1 + kRectangleKindCount));
    if (kind == ShapeKind::sphere) {
      scene.add_sphere({numbers.point(), numbers.coordinate()}, material);
    } else {
      const Vec3d a = numbers.point();
      const Vec3d b = numbers.point();
      scene.add_rectangle(kind, {a.x, b.x, a.y, b.y, a.z}, material);
    }
  }
  return scene;
}

}  // namespace dapple::test
