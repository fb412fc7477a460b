// Broken glTF files end in an error that says where, or in a warning; never in silence.
#include <gtest/gtest.h>

#include <cmath>

#include "import/gltf/container.h"
#include "import/json_value.h"
#include "import/limits.h"
#include "tests/import/gltf_text.h"

namespace dapple {
namespace {

std::string error_of(const std::string& text, const ImportOptions& options = {}) {
  const auto result = import_text(text, options);
  return result ? "" : to_string(result.error());
}

#define EXPECT_ERROR(text, part) \
  EXPECT_NE(error_of(text).find(part), std::string::npos) << error_of(text)

std::string with_nodes(const std::string& nodes) {
  return R"({"asset":{"version":"2.0"},"nodes":)" + nodes + R"(,"scenes":[{"nodes":[0]}]})";
}

TEST(BrokenGltf, NodesFormTrees) {
  EXPECT_ERROR(with_nodes(R"([{"children":[1]},{"children":[2]},{"children":[1]}])"),
               "/nodes/1: it is a child of both");
  EXPECT_ERROR(with_nodes(R"([{},{"children":[2]},{"children":[1]}])"), "its own ancestor");
  EXPECT_ERROR(with_nodes(R"([{"children":[0]}])"), "/nodes/0: the node is its own ancestor");
  EXPECT_ERROR(with_nodes(R"([{"children":[7]}])"), "/nodes/0/children/0: 7 is beyond the 1 nodes");
}

TEST(BrokenGltf, StructureIsChecked) {
  EXPECT_ERROR("[]", "not an object");
  EXPECT_ERROR("{}", "/asset: is missing");
  EXPECT_ERROR(R"({"asset":{"version":"1.0"}})", "version 1.0 of glTF is not supported");
  EXPECT_ERROR(R"({"asset":{"version":"2.0"},"nodes":{}})", "/nodes: is not an array");
  EXPECT_ERROR(with_nodes(R"([{"translation":[1,2]}])"), "/nodes/0/translation: has 2 items");
  EXPECT_ERROR(with_nodes(R"([{"translation":[1,2,"3"]}])"), "/nodes/0/translation/2");
  EXPECT_ERROR(with_nodes(R"([{"mesh":0}])"), "/nodes/0/mesh: 0 is beyond the 0 meshes");
  EXPECT_ERROR(R"({"asset":{"version":"2.0"},"extensionsUsed":["A"],"extensionsRequired":["A"]})",
               "A is required but not supported");
}

TEST(BrokenGltf, WhatIsNotThereIsMissedInItsFile) {
  ImportOptions options;
  options.scene = "Absent";
  const std::string text =
      R"({"asset":{"version":"2.0"},"scenes":[{"name":"Hall"},{}],"nodes":[{}]})";
  const std::string scene = error_of(text, options);
  EXPECT_NE(scene.find(".gltf: there is no scene"), std::string::npos) << scene;
  EXPECT_NE(scene.find(R"("Hall", one without a name)"), std::string::npos) << scene;
  options = {};
  options.variant = "Absent";
  EXPECT_NE(error_of(text, options).find(".gltf: the file has no variant"), std::string::npos)
      << error_of(text, options);
}

TEST(BrokenGltf, AnErrorOfJsonIsOneShortLine) {
  // Cut inside of a data URI, as an interrupted transfer leaves it.
  const std::string text =
      R"({"asset":{"version":"2.0"},"buffers":[{"uri":"data:;base64,)" + std::string(100'000, 'A');
  const std::string error = error_of(text);
  EXPECT_NE(error.find("missing closing quote"), std::string::npos) << error;
  EXPECT_NE(error.find("byte 100"), std::string::npos) << error;
  EXPECT_LT(error.size(), 400u);
  const std::string odd = error_of("{\"a\": \"\xff" + std::string(1000, '\n'));
  EXPECT_LT(odd.size(), 400u);
  EXPECT_EQ(odd.find('\n'), std::string::npos);
}

TEST(BrokenGltf, UnknownOptionalExtensionsAreWarnings) {
  const auto result = import_text(one_triangle("", R"(,"extensionsUsed":["EXT_unheard_of"])"));
  ASSERT_TRUE(result.has_value()) << to_string(result.error());
  ASSERT_EQ(result->warnings.size(), 2u);  // the other one: no min and max
  EXPECT_NE(fmt::format("{}", fmt::join(result->warnings, "\n")).find("EXT_unheard_of"),
            std::string::npos);
}

std::string triangle(const std::vector<float>& positions,
                     const std::vector<std::uint16_t>& indices) {
  GltfText file;
  const auto p = file.vec3(positions);
  const auto i = file.indices(indices);
  return file.text(fmt::format(
      R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":{}}},"indices":{}}}]}}],"nodes":[{{"mesh":0}}],"scenes":[{{"nodes":[0]}}])",
      p, i));
}

TEST(BrokenGltf, AttributesHaveTheirTypes) {
  for (const char* name : {"NORMAL", "TANGENT", "TEXCOORD_0", "COLOR_0", "WEIGHTS_0"}) {
    GltfText file;
    const auto p = file.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const auto scalars = file.values(std::vector<float>{7, 7, 7}, "SCALAR", 1, 5126);
    const auto joints = file.values(std::vector<std::uint8_t>(12, 0), "VEC4", 4, 5121);
    EXPECT_ERROR(
        file.text(fmt::format(
            R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":{},"JOINTS_0":{},"{}":{}}}}}]}}],"nodes":[{{"mesh":0}}],"scenes":[{{"nodes":[0]}}])",
            p, joints, name, scalars)),
        std::string("attributes/") + name);
  }
}

TEST(BrokenGltf, IndicesStayWithinTheVertices) {
  EXPECT_ERROR(triangle({0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 3}),
               "/meshes/0/primitives/0/indices: 1 of its 3 indices are beyond the 3 vertices");
}

TEST(BrokenGltf, CoordinatesAreFinite) {
  const std::string text =
      triangle({0, 0, 0, 1, 0, 0, 0, 1, 0, std::nanf(""), 0, 0}, {0, 1, 2, 0, 1, 3});
  EXPECT_ERROR(text, "1 of its numbers are not finite, first that of element 3");
  ImportOptions options;
  options.keep_going = true;
  const auto result = import_text(text, options);
  ASSERT_TRUE(result.has_value()) << to_string(result.error());
  EXPECT_EQ(result->scene.triangles.size(), 1u);
  EXPECT_NE(fmt::format("{}", fmt::join(result->warnings, "\n")).find("1 triangles have corners"),
            std::string::npos);
}

TEST(BrokenGltf, TrianglesWithoutAreaAreCounted) {
  const auto result =
      import_text(triangle({0, 0, 0, 1, 0, 0, 0, 1, 0, 2, 0, 0}, {0, 1, 2, 0, 1, 3, 0, 0, 1}));
  ASSERT_TRUE(result.has_value()) << to_string(result.error());
  EXPECT_EQ(result->scene.triangles.size(), 1u);
  EXPECT_NE(fmt::format("{}", fmt::join(result->warnings, "\n")).find("2 triangles have no area"),
            std::string::npos);
}

TEST(BrokenGltf, AccessorsStayWithinTheirViews) {
  GltfText file;
  const auto view = file.view<float>({0, 0, 0, 1, 0, 0});
  const auto too_many = file.accessor(
      fmt::format(R"("bufferView":{},"componentType":5126,"count":3,"type":"VEC3")", view));
  EXPECT_ERROR(
      file.text(fmt::format(R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":{}}}}}]}}])",
                            too_many)),
      "/accessors/0: 3 elements do not fit");
  GltfText huge;
  huge.view<float>({0});
  huge.accessor(R"("bufferView":0,"componentType":5126,"count":9007199254740991,"type":"MAT4")");
  EXPECT_ERROR(huge.text(R"("scene":0,"scenes":[{}])"), "do not fit");
}

TEST(BrokenGltf, HugeCountsEndBeforeTheyTakeMemory) {
  GltfText file;
  file.view<float>({0});
  const auto zeros = file.accessor(R"("componentType":5126,"count":4000000000,"type":"VEC3")");
  EXPECT_ERROR(
      file.text(fmt::format(
          R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":{}}}}}]}}],"nodes":[{{"mesh":0}}],"scenes":[{{"nodes":[0]}}])",
          zeros)),
      "more than the 8589934592 bytes");
}

TEST(BrokenGltf, NoNameLeavesTheFolder) {
  EXPECT_ERROR(R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":1,"uri":"../secret.bin"}]})",
               "outside the folder");
  EXPECT_ERROR(
      R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":1,"uri":"file:///etc/hostname"}]})",
      "is no file beside this one");
  EXPECT_ERROR(
      R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":1,"uri":"%2e%2e%2fsecret"}]})",
      "outside the folder");
}

TEST(BrokenGltf, AnEmptySceneSaysSo) {
  const auto result = import_text(with_nodes("[{}]"));
  ASSERT_TRUE(result.has_value());
  EXPECT_NE(fmt::format("{}", fmt::join(result->warnings, "\n")).find("shows nothing"),
            std::string::npos);
}

TEST(Json, WhatIsNoJsonIsRefused) {
  for (const char* text : {"", "{", "[1,]", "{\"a\":1}x", "nul", "\"\xff\"", "1e999"}) {
    EXPECT_FALSE(parse_json(text).has_value()) << text;
  }
  const auto twice = parse_json(R"({"a":1,"b":2,"a":3})");
  ASSERT_FALSE(twice.has_value());
  EXPECT_NE(to_string(twice.error()).find("two members \"a\""), std::string::npos);
  EXPECT_TRUE(parse_json(std::string(kMaxJsonDepth, '[') + std::string(kMaxJsonDepth, ']')));
  EXPECT_FALSE(parse_json(std::string(100000, '[')));
  EXPECT_FALSE(parse_json("[1,2,3,4]", 4).has_value());
}

TEST(Json, AbsentValuesReadAsDefaults) {
  const auto json = parse_json(R"({"a":[1,2.5,"x"],"b":{"c":true}})");
  ASSERT_TRUE(json.has_value());
  EXPECT_EQ((*json)["a"][0].index(), 1u);
  EXPECT_FALSE((*json)["a"][1].index().has_value());
  EXPECT_EQ((*json)["a"][2].text(), "x");
  EXPECT_TRUE((*json)["b"]["c"].bool_or(false));
  EXPECT_TRUE((*json)["b"]["no"]["way"][7].is_null());
}

std::string little_endian(std::uint32_t value) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i));
  return bytes;
}

std::string glb(const std::string& json, const std::string& bin) {
  const auto length = static_cast<std::uint32_t>(28 + json.size() + bin.size());
  return "glTF" + little_endian(2) + little_endian(length) +
         little_endian(static_cast<std::uint32_t>(json.size())) + "JSON" + json +
         little_endian(static_cast<std::uint32_t>(bin.size())) + std::string("BIN\0", 4) + bin;
}

TEST(GlbContainer, TruncationsAreErrors) {
  const std::string whole = glb("{}  ", "12345678");
  for (std::size_t size = 4; size <= whole.size(); ++size) {
    const auto bytes = std::as_bytes(std::span(whole.data(), size));
    EXPECT_EQ(gltf::split_container(bytes).has_value(), size == whole.size()) << size;
  }
  const auto container = gltf::split_container(std::as_bytes(std::span(whole)));
  EXPECT_EQ(container->text, "{}  ");
  EXPECT_EQ(container->bin->size(), 8u);
}

}  // namespace
}  // namespace dapple
