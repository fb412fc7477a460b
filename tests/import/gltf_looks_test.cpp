// Materials, textures, cameras and lights of glTF files.
#include <gtest/gtest.h>

#include "tests/import/gltf_text.h"

namespace dapple {
namespace {

// A 1 x 1 PNG of opaque white.
constexpr const char* kPng =
    "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAAC0lEQVR4nGP4DwQACfsD/f"
    "teaysAAAAASUVORK5CYII=";

std::string with_material(const std::string& material, const std::string& rest = "") {
  GltfText file;
  const auto positions = file.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const auto uvs = file.vec2({0, 0, 1, 0, 0, 1});
  return file.text(fmt::format(
      R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":{},"TEXCOORD_0":{}}},"material":0}}]}}],"nodes":[{{"mesh":0}}],"scenes":[{{"nodes":[0]}}],"materials":[{{{}}}]{})",
      positions, uvs, material, rest));
}

std::string image_text(const std::string& uri) {
  return R"(,"textures":[{"source":0}],"images":[{"uri":")" + uri + R"("}])";
}

const LayeredMaterial& only_material(const Expected<ImportResult>& result) {
  static const LayeredMaterial none;
  EXPECT_TRUE(result.has_value()) << (result ? "" : to_string(result.error()));
  if (!result || result->scene.layered_materials.size() != 1) return none;
  return result->scene.layered_materials[0];
}

TEST(GltfLooks, DefaultsAreThoseOfGltf) {
  const auto without = import_text(one_triangle());
  EXPECT_EQ(only_material(without).metallic, 1);
  EXPECT_EQ(only_material(without).roughness, 1);
  EXPECT_EQ(only_material(without).double_sided, 0u);
  const auto empty = import_text(with_material(R"("name":"x")"));
  EXPECT_EQ(only_material(empty), only_material(without));
}

TEST(GltfLooks, ExtensionsReachTheLayeredMaterial) {
  const auto result = import_text(with_material(R"(
    "emissiveFactor":[1,0.5,0],"alphaMode":"MASK","alphaCutoff":0.25,"doubleSided":true,
    "extensions":{
      "KHR_materials_emissive_strength":{"emissiveStrength":4},
      "KHR_materials_ior":{"ior":1.25},
      "KHR_materials_transmission":{"transmissionFactor":0.75},
      "KHR_materials_volume":{"thicknessFactor":2,"attenuationDistance":3,"attenuationColor":[0.5,1,1]},
      "KHR_materials_clearcoat":{"clearcoatFactor":0.5},
      "KHR_materials_sheen":{"sheenColorFactor":[0,1,0]},
      "KHR_materials_dispersion":{"dispersion":0.5}})"));
  const LayeredMaterial& m = only_material(result);
  EXPECT_EQ(m.emission, Vec3f(4, 2, 0));
  EXPECT_EQ(m.alpha_mode, AlphaMode::mask);
  EXPECT_EQ(m.alpha_cutoff, 0.25f);
  EXPECT_EQ(m.double_sided, 1u);
  EXPECT_EQ(m.ior, 1.25f);
  EXPECT_EQ(m.transmission, 0.75f);
  EXPECT_EQ(m.thickness, 2);
  EXPECT_EQ(m.attenuation_distance, 3);
  EXPECT_EQ(m.attenuation_colour, Vec3f(0.5f, 1, 1));
  EXPECT_EQ(m.clearcoat, 0.5f);
  EXPECT_EQ(m.sheen_colour, Vec3f(0, 1, 0));
  EXPECT_EQ(m.dispersion, 0.5f);
}

TEST(GltfLooks, TextureTransformsAreAppliedInTheirOrder) {
  const auto result = import_text(with_material(
      R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0,"extensions":{"KHR_texture_transform":{"offset":[0.5,0.25],"rotation":1.5707963267948966,"scale":[2,4]}}}})",
      image_text(kPng)));
  const TextureSlot& slot = only_material(result).map(MapUse::base_colour);
  ASSERT_NE(slot.texture, kNoTexture);
  // u' = s_y v + offset, v' = -s_x u + offset
  const float expected[2][3] = {{0, 4, 0.5f}, {-2, 0, 0.25f}};
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(slot.to_uv[i][j], expected[i][j], 1e-6);
  }
}

TEST(GltfLooks, ANormalMapBringsTangents) {
  const auto result =
      import_text(with_material(R"("normalTexture":{"index":0})", image_text(kPng)));
  ASSERT_TRUE(result.has_value()) << to_string(result.error());
  ASSERT_EQ(result->scene.vertices.tangents.size(), 3u);
  // u grows along x; v grows along y where images grow against it, so the side is mirrored.
  EXPECT_EQ(result->scene.vertices.tangents[0], (Vec4f{1, 0, 0, -1}));
}

TEST(GltfLooks, AMissingPictureIsAnErrorOrMagenta) {
  const std::string text = with_material(
      R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0}})", image_text("gone.png"));
  const auto refused = import_text(text);
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(to_string(refused.error()).find("gone.png"), std::string::npos);
  ImportOptions options;
  options.keep_going = true;
  const auto result = import_text(text, options);
  ASSERT_TRUE(result.has_value());
  EXPECT_NE(fmt::format("{}", fmt::join(result->warnings, "\n")).find("gone.png"),
            std::string::npos);
  ASSERT_EQ(result->scene.texels.size(), 4u);
  EXPECT_EQ(result->scene.texels, (std::vector<std::uint8_t>{255, 0, 255, 255}));
}

TEST(GltfLooks, VariantsAreChosenByName) {
  GltfText file;
  const auto positions = file.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const std::string text = file.text(fmt::format(
      R"("extensionsUsed":["KHR_materials_variants"],"extensions":{{"KHR_materials_variants":{{"variants":[{{"name":"day"}},{{"name":"night"}}]}}}},"meshes":[{{"primitives":[{{"attributes":{{"POSITION":{}}},"material":0,"extensions":{{"KHR_materials_variants":{{"mappings":[{{"material":1,"variants":[1]}}]}}}}}}]}}],"nodes":[{{"mesh":0}}],"scenes":[{{"nodes":[0]}}],"materials":[{{"alphaMode":"BLEND"}},{{"alphaMode":"MASK"}}])",
      positions));
  const auto mode_of = [&](const char* variant) {
    ImportOptions options;
    options.variant = variant;
    return only_material(import_text(text, options)).alpha_mode;
  };
  EXPECT_EQ(mode_of(""), AlphaMode::blend);
  EXPECT_EQ(mode_of("day"), AlphaMode::blend);
  EXPECT_EQ(mode_of("night"), AlphaMode::mask);
  ImportOptions options;
  options.variant = "noon";
  const auto refused = import_text(text, options);
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(to_string(refused.error()).find("\"day\", \"night\""), std::string::npos);
}

TEST(GltfLooks, CamerasLookDownTheirNegativeZ) {
  const auto result = import_text(one_triangle(
      R"(,"children":[1]},{"camera":0,"name":"left","translation":[3,0,0],"rotation":[0,0.70710678,0,0.70710678])",
      R"(,"cameras":[{"type":"perspective","perspective":{"yfov":1.5707963267948966,"znear":0.1}}])"));
  ASSERT_TRUE(result.has_value()) << to_string(result.error());
  ASSERT_EQ(result->scene.cameras.size(), 1u);
  const Camera& camera = result->scene.camera;
  EXPECT_STREQ(result->scene.cameras[0].name.data(), "left");
  EXPECT_NEAR(camera.vertical_fov, 90, 1e-9);
  EXPECT_NEAR((camera.look_at - camera.look_from).x, -1, 1e-6);
  EXPECT_EQ(camera.aperture, 0);
}

TEST(GltfLooks, LampsTakeThePlaceOfTheStudio) {
  const auto result = import_text(one_triangle(
      R"(,"extensions":{"KHR_lights_punctual":{"light":0}},"translation":[0,5,0])",
      R"(,"extensionsUsed":["KHR_lights_punctual"],"extensions":{"KHR_lights_punctual":{"lights":[{"type":"spot","intensity":10,"color":[1,0.5,0],"spot":{"outerConeAngle":0.5}}]}})"));
  ASSERT_TRUE(result.has_value()) << to_string(result.error());
  ASSERT_EQ(result->scene.lights.size(), 1u);
  const Light& light = result->scene.lights[0];
  EXPECT_EQ(light.kind, LightKind::spot);
  EXPECT_EQ(light.position, Vec3f(0, 5, 0));
  EXPECT_EQ(light.direction, Vec3f(0, 0, -1));
  // Candela over 683 lumens per watt.
  EXPECT_LT(max_abs_component(light.intensity - Vec3f(10.0f / 683, 5.0f / 683, 0)), 1e-8f);
  EXPECT_EQ(light.outer_angle, 0.5f);
  EXPECT_EQ(result->scene.environment.kind, EnvironmentKind::none);
}

}  // namespace
}  // namespace dapple
