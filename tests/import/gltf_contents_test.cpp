// What is wrong in a glTF file, but not in what its scene shows, is named in warnings.
#include <gtest/gtest.h>

#include <limits>

#include "tests/import/gltf_text.h"

namespace dapple {
namespace {

std::string warnings_of(const std::string& text, const ImportOptions& options = {}) {
  const auto result = import_text(text, options);
  if (!result) return "error: " + to_string(result.error());
  return fmt::format("{}", fmt::join(result->warnings, "\n"));
}

#define EXPECT_WARNING(text, part) \
  EXPECT_NE(warnings_of(text).find(part), std::string::npos) << warnings_of(text)
#define EXPECT_NO_WARNING(text, part) \
  EXPECT_EQ(warnings_of(text).find(part), std::string::npos) << warnings_of(text)

// A file whose one mesh no node shows.
std::string hidden_mesh(const GltfText& file, const std::string& primitive,
                        const std::string& rest = "") {
  return file.text(fmt::format(R"("meshes":[{{"primitives":[{{{}}}]}}]{})", primitive, rest));
}

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(GltfContents, AccessorsThatNothingReadsAreRead) {
  GltfText file;
  file.vec3({0, 0, kNan});
  file.values(std::vector<std::uint8_t>{1, 9, 2, 0}, "SCALAR", 1, 5121, R"(,"min":[1],"max":[3])");
  EXPECT_WARNING(file.text(R"("scenes":[{}])"), "/accessors/0: 1 of its numbers are not finite");
  EXPECT_WARNING(file.text(R"("scenes":[{}])"), "/accessors/1: its numbers are not from its min");
}

TEST(GltfContents, AccessorsWithoutDataAreZerosOnPurpose) {
  GltfText file;
  file.accessor(R"("componentType":5126,"count":3,"type":"VEC3","min":[1,1,1],"max":[2,2,2])");
  EXPECT_NO_WARNING(file.text(R"("scenes":[{}])"), "min");
}

TEST(GltfContents, AnAccessorOfUnknownTypeHarmsOnlyWhatReadsIt) {
  GltfText file;
  file.vec3({0, 0, 0});
  file.accessor(R"("componentType":5126,"count":3,"type":"VEC7")");
  EXPECT_WARNING(file.text(R"("scenes":[{}])"), "/accessors/1/type: VEC7 is not known");
  const std::string shown = file.text(
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":1}}]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}])");
  EXPECT_WARNING(shown, "error: ");
}

TEST(GltfContents, MeshesThatNoNodeShowsAreRead) {
  GltfText file;
  const auto p = file.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const auto i = file.indices({0, 1, 7});
  EXPECT_WARNING(
      hidden_mesh(file, fmt::format(R"("attributes":{{"POSITION":{}}},"indices":{})", p, i)),
      "/meshes/0/primitives/0/indices: 1 of its 3 indices are beyond the 3 vertices");
}

TEST(GltfContents, TheRestartIndexIsDoubtful) {
  GltfText file;
  const auto p = file.vec3(std::vector<float>(256 * 3, 1.0f));
  const auto i = file.values(std::vector<std::uint8_t>{0, 1, 255, 0}, "SCALAR", 1, 5121);
  EXPECT_WARNING(
      hidden_mesh(file,
                  fmt::format(R"("attributes":{{"POSITION":{}}},"indices":{},"mode":0)", p, i)),
      "1 of its indices are 255, which restarts primitives elsewhere");
}

std::string animated(const std::vector<float>& times, const std::vector<float>& rotations) {
  GltfText file;
  const auto t = file.values(times, "SCALAR", 1, 5126);
  const auto r = file.values(rotations, "VEC4", 4, 5126);
  return file.text(fmt::format(
      R"("nodes":[{{}}],"scenes":[{{"nodes":[0]}}],"animations":[{{"samplers":[{{"input":{},"output":{}}}],"channels":[{{"sampler":0,"target":{{"node":0,"path":"rotation"}}}}]}}])",
      t, r));
}

TEST(GltfContents, AnimationsAreReadWithoutATime) {
  const std::vector<float> turns = {0, 0, 0, 1, 1, 0, 0, 0};
  EXPECT_WARNING(animated({0, 0}, turns), "/samplers/0/input: 1 of its times");
  EXPECT_WARNING(animated({-1, 0}, turns), "/samplers/0/input: 1 of its times");
  EXPECT_NO_WARNING(animated({0, 1}, turns), "of its times");
  EXPECT_WARNING(animated({0, 1}, {0, 0, 0, 1, 1, 1, 0, 0}),
                 "/samplers/0/output: 1 of its rotations are not of unit length");
  EXPECT_NO_WARNING(animated({0, 1}, turns), "unit length");
}

std::string skinned(const std::string& nodes, const std::string& skin) {
  return R"({"asset":{"version":"2.0"},"nodes":)" + nodes + R"(,"skins":[{)" + skin + "}]}";
}

TEST(GltfContents, JointsHangTogetherBelowTheirSkeleton) {
  const std::string trees = R"([{"children":[1,2]},{},{"children":[3]},{},{}])";
  EXPECT_WARNING(skinned(trees, R"("joints":[1,4])"), "/skins/0/joints: have no common root");
  EXPECT_NO_WARNING(skinned(trees, R"("joints":[1,3])"), "common root");
  EXPECT_WARNING(skinned(trees, R"("joints":[1,3],"skeleton":2)"),
                 "/skins/0/skeleton: 1 joints are not below it");
  EXPECT_NO_WARNING(skinned(trees, R"("joints":[2,3],"skeleton":2)"), "skeleton");
}

TEST(GltfContents, BindMatricesAreAffine) {
  GltfText file;
  const auto m = file.values(std::vector<float>{1, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},
                             "MAT4", 16, 5126);
  EXPECT_WARNING(file.text(fmt::format(
                     R"("nodes":[{{}}],"skins":[{{"joints":[0],"inverseBindMatrices":{}}}])", m)),
                 "1 of its matrices have a last row that is not 0 0 0 1");
}

std::string with_image(const std::string& image) {
  return R"({"asset":{"version":"2.0"},"images":[)" + image + "]}";
}

TEST(GltfContents, ImagesThatNoSurfaceShowsAreLookedAt) {
  EXPECT_WARNING(with_image(R"({"uri":"absent.png"})"), "absent.png: cannot open");
  EXPECT_WARNING(with_image(R"({"uri":"absent.png"})"), "no surface shows it");
  EXPECT_WARNING(with_image(R"({"uri":":"})"), "is no file beside this one");
  EXPECT_WARNING(with_image(R"({"uri":"data:image/png;base64,`"})"), "its data is not base64");
  EXPECT_WARNING(with_image(R"({"uri":"data:image/png;;base64,AA=="})"), "malformed type");
  EXPECT_WARNING(with_image(R"({"uri":"data:image/gif;base64,AA=="})"), "not a type of glTF's");
  EXPECT_WARNING(
      with_image(R"({"uri":"data:image/png;base64,iVBORw0KGgo=","mimeType":"image/jpeg"})"),
      "says image/jpeg, but it is image/png");
  EXPECT_WARNING(with_image(R"({"uri":"data:image/png;base64,iVBORw0KGgo="})"), "/images/0: ");
}

TEST(GltfContents, TexturesThatSurfacesDoNotShowMayBeMissing) {
  GltfText file;
  const auto p = file.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const auto uv = file.vec2({0, 0, 1, 0, 0, 1});
  const auto text = [&](const char* material) {
    return file.text(fmt::format(
        R"("images":[{{"uri":"absent.png"}}],"textures":[{{"source":0}}],"materials":[{{{}}},{{"emissiveTexture":{{"index":0}}}}],"meshes":[{{"primitives":[{{"attributes":{{"POSITION":{},"TEXCOORD_0":{}}},"material":0}}]}}],"nodes":[{{"mesh":0}}],"scenes":[{{"nodes":[0]}}])",
        material, p, uv));
  };
  EXPECT_WARNING(text(""), "no surface shows it");
  EXPECT_WARNING(text(R"("occlusionTexture":{"index":0})"), "no surface shows it");
  const std::string shown = warnings_of(text(R"("normalTexture":{"index":0})"));
  EXPECT_TRUE(shown.starts_with("error: ")) << shown;
  EXPECT_NE(shown.find("absent.png"), std::string::npos) << shown;
}

TEST(GltfContents, BuffersSayWhereTheirDataIs) {
  const auto buffer = [](const std::string& members) {
    return R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":1)" + members + "}]}";
  };
  EXPECT_WARNING(buffer(""), "/buffers/0: it has neither a uri");
  EXPECT_WARNING(buffer(R"(,"uri":"data:text/plain;base64,AA==")"), "not a type of glTF's buffers");
  EXPECT_WARNING(buffer(R"(,"uri":"data:application/octet-stream;;base64,AA==")"), "error: ");
  EXPECT_NO_WARNING(buffer(R"(,"uri":"data:application/octet-stream;base64,AA==")"), "/buffers/0");
}

TEST(GltfContents, AttributesThatShareAViewNeedAStride) {
  GltfText file;
  const auto view = file.view(std::vector<float>(18, 1.0f));
  const auto half = [&](int offset) {
    return file.accessor(fmt::format(
        R"("bufferView":{},"byteOffset":{},"componentType":5126,"count":3,"type":"VEC3")", view,
        offset));
  };
  const auto p = half(0), n = half(36);
  EXPECT_WARNING(
      hidden_mesh(file, fmt::format(R"("attributes":{{"POSITION":{},"NORMAL":{}}})", p, n)),
      "/bufferViews/0: several attributes share it");
  EXPECT_NO_WARNING(
      hidden_mesh(file, fmt::format(R"("attributes":{{"POSITION":{},"NORMAL":{}}})", p, p)),
      "several attributes share it");
  EXPECT_WARNING(
      hidden_mesh(file, fmt::format(R"("attributes":{{"POSITION":{},"_OWN":{}}})", p, half(2))),
      "/attributes/_OWN: its elements do not begin at multiples of four bytes");
}

TEST(GltfContents, VariantsAreDeclaredAndMappedOnce) {
  GltfText file;
  const auto p = file.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const std::string primitive = fmt::format(
      R"("attributes":{{"POSITION":{}}},"extensions":{{"KHR_materials_variants":{{"mappings":[{{"material":0,"variants":[0]}},{{"material":0,"variants":[0,3]}}]}}}})",
      p);
  const std::string materials = R"(,"materials":[{}],"extensionsUsed":["KHR_materials_variants"])";
  EXPECT_WARNING(hidden_mesh(file, primitive, materials), "the root of the file names no variants");
  const std::string declared =
      materials + R"(,"extensions":{"KHR_materials_variants":{"variants":[{"name":"a"}]}})";
  EXPECT_WARNING(hidden_mesh(file, primitive, declared), "maps variant 0 twice");
  EXPECT_WARNING(hidden_mesh(file, primitive, declared), "variant 3 does not exist");
}

TEST(GltfContents, MaterialsFindTheirTangents) {
  GltfText file;
  const auto p = file.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const auto uv = file.vec2({0, 0, 1, 0, 0, 1});
  const auto text = [&](const std::string& more) {
    return hidden_mesh(
        file, fmt::format(R"("attributes":{{"POSITION":{}{}}},"material":0)", p, more),
        R"(,"materials":[{"extensions":{"KHR_materials_anisotropy":{"anisotropyStrength":1}}}])");
  };
  EXPECT_WARNING(text(""), "neither it nor texture coordinates give");
  EXPECT_WARNING(text(fmt::format(R"(,"TEXCOORD_0":{})", uv)), "they follow the texture");
}

TEST(GltfContents, ATransformChoosesTheCoordinatesOfItsTexture) {
  GltfText file;
  const auto p = file.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const auto uv = file.vec2({0, 0, 1, 0, 0, 1});
  const auto text = [&](int set) {
    return hidden_mesh(
        file, fmt::format(R"("attributes":{{"POSITION":{},"TEXCOORD_0":{}}},"material":0)", p, uv),
        fmt::format(
            R"(,"images":[{{"uri":"a.png"}}],"textures":[{{"source":0}}],"materials":[{{"emissiveTexture":{{"index":0,"texCoord":1,"extensions":{{"KHR_texture_transform":{{"texCoord":{}}}}}}}}}])",
            set));
  };
  EXPECT_NO_WARNING(text(0), "needs TEXCOORD_");
  EXPECT_WARNING(text(1), "needs TEXCOORD_1");
}

}  // namespace
}  // namespace dapple
