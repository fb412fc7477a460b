#include "tests/scenes/picture_scenes.h"

namespace dapple::test {
namespace {

Camera camera_at(const Vec3d& look_from, const Vec3d& look_at, double fov) {
  Camera camera;
  camera.look_from = look_from;
  camera.look_at = look_at;
  camera.vertical_fov = fov;
  return camera;
}

}  // namespace

Scene glass_scene() {
  Scene scene;
  scene.camera = camera_at({0, 2, 8}, {0, 1, 0}, 50);
  const MaterialId glass = scene.add_material(Dielectric{1.5});
  const MaterialId diamond = scene.add_material(Dielectric{2.4});
  const MaterialId bubble = scene.add_material(Dielectric{0.75});
  const MaterialId floor = scene.add_material(Lambertian{{0.7, 0.5, 0.3}});
  scene.add_sphere({{-2.5, 1, 0}, 1}, glass);
  scene.add_sphere({{0, 1, 0}, 1}, glass);
  scene.add_sphere({{0, 1, 0}, -0.8}, glass);  // inside out: the air in a hollow ball
  scene.add_sphere({{2.5, 1, 0}, 1}, diamond);
  scene.add_sphere({{1.2, 0.6, 2.5}, 0.6}, bubble);
  scene.add_sphere({{0, -100, 0}, 100}, floor);
  scene.add_rectangle(ShapeKind::xy_rectangle, {-4, -1, 0, 3, 2}, glass);  // a pane: one surface
  return scene;
}

Scene inside_glass_scene() {
  Scene scene;
  scene.camera = camera_at({0.3, 0.2, 0.5}, {0, 0, -1}, 75);
  scene.camera.focus_distance = 1;
  const MaterialId glass = scene.add_material(Dielectric{1.5});
  const MaterialId red = scene.add_material(Lambertian{{0.8, 0.2, 0.1}});
  const MaterialId mirror = scene.add_material(Metal{{0.9, 0.9, 0.7}, 0});
  scene.add_sphere({{0, 0, 0}, 2}, glass);
  scene.add_sphere({{0.5, 0, -1}, 0.3}, red);
  scene.add_sphere({{-2, 0, -6}, 2}, mirror);
  scene.add_sphere({{3, 0, -6}, 2}, red);
  return scene;
}

Scene rectangle_scene() {
  Scene scene;
  scene.camera = camera_at({0.5, 1.5, 7}, {0, 1, 0}, 60);
  const MaterialId red = scene.add_material(Lambertian{{0.9, 0.2, 0.2}});
  const MaterialId green = scene.add_material(Lambertian{{0.2, 0.9, 0.2}});
  const MaterialId blue = scene.add_material(Metal{{0.3, 0.3, 0.9}, 0.3});
  const MaterialId mirror = scene.add_material(Metal{{0.9, 0.9, 0.9}, 0});
  // Between camera and room: seen from the side of +x, +y, +z and, through mirrors, from the other.
  scene.add_rectangle(ShapeKind::yz_rectangle, {-1, 3, -3, 3, -3}, red);
  scene.add_rectangle(ShapeKind::yz_rectangle, {-1, 3, -3, 3, 3}, green);
  scene.add_rectangle(ShapeKind::xz_rectangle, {-3, 3, -3, 3, -1}, blue);
  scene.add_rectangle(ShapeKind::xz_rectangle, {-2, 2, -2, 2, 3.5}, red);
  scene.add_rectangle(ShapeKind::xy_rectangle, {-3, 3, -1, 3, -3}, mirror);
  scene.add_rectangle(ShapeKind::xy_rectangle, {-1, 1, 0, 2, 0}, green);
  scene.add_rectangle(ShapeKind::xy_rectangle, {-0.5, 0.5, 0.5, 1.5, 0.5}, mirror);
  return scene;
}

Scene wide_lens_scene() {
  Scene scene;
  scene.camera = camera_at({0, 0, 10}, {0, 0, 0}, 40);
  scene.camera.aperture = 2;
  const MaterialId dark = scene.add_material(Lambertian{{0.05, 0.1, 0.2}});
  const MaterialId mirror = scene.add_material(Metal{{0.8, 0.8, 0.8}, 0});
  scene.add_sphere({{-2, 0, 5}, 0.5}, dark);
  scene.add_sphere({{0, 0, 0}, 1}, dark);
  scene.add_sphere({{3, 1, -10}, 2}, mirror);
  scene.add_rectangle(ShapeKind::xy_rectangle, {1, 2, -3, -2, 3}, dark);
  return scene;
}

Scene tilted_camera_scene() {
  Scene scene;
  scene.camera = camera_at({3, 4, -5}, {0.5, 0, 1}, 100);
  scene.camera.up = {0.4, 2, 0.3};
  scene.camera.focus_distance = 3;
  const MaterialId rough = scene.add_material(Metal{{0.9, 0.6, 0.3}, 1.5});
  const MaterialId matt = scene.add_material(Lambertian{{0.5, 0.6, 0.7}});
  scene.add_sphere({{0, 0, 0}, 1.5}, rough);
  scene.add_sphere({{2, 1, 1}, -1}, matt);  // inside out makes no difference to a matt ball
  scene.add_rectangle(ShapeKind::xz_rectangle, {-5, 5, -5, 5, -1.5}, rough);
  scene.add_rectangle(ShapeKind::yz_rectangle, {-1, 2, -1, 3, -2}, matt);
  return scene;
}

std::vector<PictureScene> picture_scenes() {
  return {{"glass", glass_scene()},
          {"inside glass", inside_glass_scene()},
          {"rectangles", rectangle_scene()},
          {"wide lens", wide_lens_scene()},
          {"tilted camera", tilted_camera_scene()}};
}

}  // namespace dapple::test
