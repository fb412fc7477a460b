#include "tests/render/lit_scenes.h"

#include <gtest/gtest.h>

namespace dapple::test {

Scene empty_lit_scene(double height, double distance) {
  Scene scene;
  scene.camera.look_from = {0, 0, distance};
  scene.camera.look_at = {0, 0, 0};
  scene.camera.aperture = 0;
  scene.camera.orthographic_height = height;
  scene.environment.kind = EnvironmentKind::none;
  return scene;
}

MaterialId add_layered(Scene& scene, const LayeredMaterial& material) {
  scene.layered_materials.push_back(material);
  const auto index = static_cast<std::uint32_t>(scene.layered_materials.size() - 1);
  return scene.add_material(Layered{index});
}

MaterialId add_diffuse(Scene& scene, float albedo) {
  return scene.add_material(Lambertian{{albedo, albedo, albedo}});
}

MaterialId add_emitter(Scene& scene, float radiance) {
  LayeredMaterial material;
  material.base_colour = {0, 0, 0};
  material.specular = 0;
  material.emission = {radiance, radiance, radiance};
  return add_layered(scene, material);
}

RenderResult render_lit(const Scene& scene, const LitPicture& picture) {
  RenderSettings settings;
  settings.width = settings.height = picture.side;
  settings.samples_per_pixel = picture.samples;
  settings.max_scatterings = picture.max_scatterings;
  settings.filter = FilterKind::box;
  settings.transparent_background = picture.transparent;
  settings.clamp_indirect = picture.clamp_indirect;
  const PreparedScene prepared(scene, make_accel(AccelKind::fast, scene));
  auto result = render(prepared, settings);
  EXPECT_TRUE(result);
  return std::move(*result);
}

double mean_of(const Image& image) {
  double sum = 0;
  for (const Vec3f& p : image.pixels) sum += (double{p.x} + p.y + p.z) / 3;
  return sum / static_cast<double>(image.pixels.size());
}

}  // namespace dapple::test
