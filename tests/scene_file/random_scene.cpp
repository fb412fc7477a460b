#include "tests/scene_file/random_scene.h"

#include "tests/scene_file/random_numbers.h"

namespace dapple::test {
namespace {

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
