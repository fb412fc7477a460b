// `dapple render` with models, from outside: the size of pictures, and what broken files lead to.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/apps/run_program.h"

namespace dapple {
namespace {

using Words = std::vector<std::string>;
using nlohmann::json;

std::pair<int, int> size_of_picture(const TestFolder& folder, const std::string& scene,
                                    const Words& more = {}) {
  Words words = {"dapple", "render", scene, "-o", "out.pfm", "--spp=1", "--depth=1", "--json"};
  words.insert(words.end(), more.begin(), more.end());
  const auto result = folder.run(words);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const json report = json::parse(result.out);
  return {report["width"], report["height"]};
}

TEST(RenderModels, AFilmHasTheSizeThatItsFileSays) {
  const TestFolder folder;
  folder.write("film.pbrt",
               "Film \"rgb\" \"integer xresolution\" 40 \"integer yresolution\" 20\n"
               "Camera \"perspective\"\nWorldBegin\nLightSource \"infinite\"\n"
               "Translate 0 0 5 Shape \"sphere\"\n");
  using Size = std::pair<int, int>;
  EXPECT_EQ(size_of_picture(folder, "film.pbrt"), Size(40, 20));
  EXPECT_EQ(size_of_picture(folder, "film.pbrt", {"--width=30"}), Size(30, 15));
  EXPECT_EQ(size_of_picture(folder, "film.pbrt", {"--height=30"}), Size(60, 30));
  EXPECT_EQ(size_of_picture(folder, "film.pbrt", {"--width=30", "--height=30"}), Size(30, 30));
}

TEST(RenderModels, APictureHasTheShapeThatItsCameraIsMeantFor) {
  const TestFolder folder;
  const std::string perspective = R"("type":"perspective","perspective":{"yfov":1,"znear":0.1)";
  folder.write("cameras.gltf", R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0,1]}],"nodes":[)"
                               R"({"name":"wide","camera":0},{"name":"any","camera":1}],)"
                               R"("cameras":[{)" +
                                   perspective + R"(,"aspectRatio":2}},{)" + perspective + "}}]}");
  using Size = std::pair<int, int>;
  EXPECT_EQ(size_of_picture(folder, "cameras.gltf", {"--width=40"}), Size(40, 20));
  EXPECT_EQ(size_of_picture(folder, "cameras.gltf", {"--height=40"}), Size(80, 40));
  EXPECT_EQ(size_of_picture(folder, "cameras.gltf", {"--width=40", "--camera=wide"}), Size(40, 20));
  EXPECT_EQ(size_of_picture(folder, "cameras.gltf", {"--width=40", "--height=9"}), Size(40, 9));
  // A camera of any shape, or one that is not the file's: the height has its usual default.
  EXPECT_EQ(size_of_picture(folder, "cameras.gltf", {"--width=40", "--camera=1"}), Size(40, 600));
  EXPECT_EQ(size_of_picture(folder, "cameras.gltf", {"--width=40", "--orbit=0,90,2"}),
            Size(40, 600));
}

// A grid of triangles with bumps.
std::string grid_of_triangles(int side) {
  std::string text;
  for (int y = 0; y <= side; ++y) {
    for (int x = 0; x <= side; ++x) text += fmt::format("v {} {} {}\n", x, y, (x * y) % 3);
  }
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const int a = y * (side + 1) + x + 1, b = a + side + 1;
      text += fmt::format("f {} {} {}\nf {} {} {}\n", a, a + 1, b + 1, a, b + 1, b);
    }
  }
  return text;
}

TEST(RenderModels, ACompactBvhGivesTheSamePicture) {
  const TestFolder folder;
  folder.write("grid.obj", grid_of_triangles(30));
  size_of_picture(folder, "grid.obj", {"--width=40", "--height=30"});
  const std::string expected = folder.read("out.pfm");
  size_of_picture(folder, "grid.obj", {"--width=40", "--height=30", "--bvh-compact"});
  EXPECT_EQ(folder.read("out.pfm"), expected);
}

TEST(BenchModels, ACompactBvhTakesLess) {
  const TestFolder folder;
  folder.write("grid.obj", grid_of_triangles(60));
  const auto bytes_each = [&](const Words& more) -> double {
    Words words = {"dapple", "bench", "grid.obj", "--width=8", "--height=8", "--json"};
    words.insert(words.end(), more.begin(), more.end());
    return json::parse(folder.run(words).out)["accels"][0]["bytes_per_object"];
  };
  EXPECT_LE(bytes_each({"--bvh-compact"}), 36);
  EXPECT_GT(bytes_each({}), 36);
}

TEST(RenderModels, CamerasWithoutNamesAreListedByIndex) {
  const TestFolder folder;
  folder.write("a.gltf", R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0,1]}],"nodes":[)"
                         R"({"camera":0},{"camera":0}],"cameras":[{"type":"perspective",)"
                         R"("perspective":{"yfov":1,"znear":0.1}}]})");
  const auto result = folder.run({"dapple", "render", "a.gltf", "-o", "a.pfm", "--camera=9"});
  EXPECT_EQ(result.exit_code, 64);
  EXPECT_NE(result.err.find("there are 0 to 1, without names"), std::string::npos) << result.err;
}

TEST(RenderModels, AShapeThatNoPictureCanHaveIsAnError) {
  const TestFolder folder;
  folder.write("a.gltf", R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[)"
                         R"({"camera":0}],"cameras":[{"type":"perspective","perspective":)"
                         R"({"yfov":1,"znear":0.1,"aspectRatio":1e-9}}]})");
  const Words words = {"dapple", "render", "a.gltf", "-o", "a.pfm", "--spp=1", "--width=60"};
  const auto result = folder.run(words);
  EXPECT_EQ(result.exit_code, 65);
  EXPECT_NE(result.err.find("a.gltf: its picture is 1e-09 times as wide as high"),
            std::string::npos)
      << result.err;
  EXPECT_EQ(size_of_picture(folder, "a.gltf", {"--width=6", "--height=4"}),
            (std::pair<int, int>(6, 4)));
}

TEST(RenderModels, AStoredSceneKeepsTheSizeAndTheShapeOfItsPictures) {
  const TestFolder folder;
  const std::string perspective = R"("type":"perspective","perspective":{"yfov":1,"znear":0.1)";
  folder.write("film.pbrt",
               "Film \"rgb\" \"integer xresolution\" 40 \"integer yresolution\" 20\n"
               "Camera \"perspective\"\nWorldBegin\nLightSource \"infinite\"\n"
               "Translate 0 0 5 Shape \"sphere\"\n");
  folder.write("cameras.gltf", R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0,1]}],"nodes":[)"
                               R"({"name":"wide","camera":0},{"name":"any","camera":1}],)"
                               R"("cameras":[{)" +
                                   perspective + R"(,"aspectRatio":2}},{)" + perspective + "}}]}");
  for (const std::string name : {"film.pbrt", "cameras.gltf"}) {
    const auto stored = folder.run({"dapple", "convert", name, "-o", name + ".scene"});
    ASSERT_EQ(stored.exit_code, 0) << stored.err;
  }
  using Size = std::pair<int, int>;
  EXPECT_EQ(size_of_picture(folder, "film.pbrt.scene"), Size(40, 20));
  EXPECT_EQ(size_of_picture(folder, "film.pbrt.scene", {"--height=30"}), Size(60, 30));
  EXPECT_EQ(size_of_picture(folder, "cameras.gltf.scene", {"--width=40"}), Size(40, 20));
  EXPECT_EQ(size_of_picture(folder, "cameras.gltf.scene", {"--width=40", "--camera=1"}),
            Size(40, 600));
  // What was stored once is stored again.
  ASSERT_EQ(folder.run({"dapple", "convert", "film.pbrt.scene", "-o", "again"}).exit_code, 0);
  EXPECT_EQ(size_of_picture(folder, "again"), Size(40, 20));
}

// What went wrong, and whether a picture was written.
struct Outcome {
  int exit_code = -1;
  std::string messages;
  bool has_picture = false;
};

Outcome outcome_of(const std::map<std::string, std::string>& files, const std::string& scene,
                   const Words& more = {}) {
  const TestFolder folder;
  for (const auto& [name, text] : files) folder.write(name, text);
  Words words = {"dapple", "render", scene, "-o", "out.png", "--spp=1", "--width=8", "--height=6"};
  words.insert(words.end(), more.begin(), more.end());
  const auto result = folder.run(words);
  const auto names = folder.names();
  return {result.exit_code, result.err, std::ranges::count(names, "out.png") == 1};
}

void expect_refusal(const Outcome& outcome, int exit_code, const std::string& part) {
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.messages;
  EXPECT_NE(outcome.messages.find(part), std::string::npos) << outcome.messages;
  EXPECT_FALSE(outcome.has_picture);
}

void expect_warning(const Outcome& outcome, const std::string& part) {
  EXPECT_EQ(outcome.exit_code, 0) << outcome.messages;
  EXPECT_NE(outcome.messages.find("warning: "), std::string::npos) << outcome.messages;
  EXPECT_NE(outcome.messages.find(part), std::string::npos) << outcome.messages;
  EXPECT_TRUE(outcome.has_picture);
}

TEST(RenderModels, AMissingTextureIsNamed) {
  const std::map<std::string, std::string> files = {
      {"a.obj", "mtllib a.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n"},
      {"a.mtl", "newmtl m\nmap_Kd absent.png\n"}};
  expect_refusal(outcome_of(files, "a.obj"), 66, "a.mtl:2: absent.png: cannot open");
  expect_warning(outcome_of(files, "a.obj", {"--keep-going"}), "absent.png: cannot open");
}

TEST(RenderModels, AMissingBufferIsNamed) {
  const std::map<std::string, std::string> files = {
      {"a.gltf", R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4,"uri":"absent.bin"}]})"}};
  expect_refusal(outcome_of(files, "a.gltf"), 66, "absent.bin: cannot open");
  expect_warning(outcome_of(files, "a.gltf", {"--keep-going"}), "absent.bin: cannot open");
}

TEST(RenderModels, AnErrorSaysWhyNothingIsLeft) {
  expect_refusal(outcome_of({{"a.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}}, "a.obj"), 65,
                 "1 triangles with coordinates that are not finite");
  expect_refusal(outcome_of({{"a.obj", "v 0 0 0\nv 0 0 0\nv 0 1 0\nf 1 2 3\n"}}, "a.obj"), 65,
                 "1 triangles without area");
}

// A triangle with corners of this size, seen whole.
std::string triangle_of_size(const std::string& size) {
  return "v 0 0 0\nv " + size + " 0 0\nv 0 " + size + " 0\nf 1 2 3\n";
}

TEST(RenderModels, NoSizeIsTooSmallToBeLookedAt) {
  for (const std::string size : {"1e-25", "1e-30", "1e-37"}) {
    const Outcome outcome = outcome_of({{"a.obj", triangle_of_size(size)}}, "a.obj");
    EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 65) << size << outcome.messages;
    EXPECT_FALSE(outcome.messages.empty()) << size;
  }
}

TEST(RenderModels, AnyTurnOfTheEnvironmentWillDo) {
  for (const std::string turn : {"1e39", "-1e300", "360000000090"}) {
    const Outcome outcome =
        outcome_of({{"a.obj", triangle_of_size("1")}}, "a.obj", {"--rotate=" + turn});
    EXPECT_EQ(outcome.exit_code, 0) << turn << outcome.messages;
    EXPECT_EQ(outcome.messages.find("not finite"), std::string::npos) << outcome.messages;
  }
}

TEST(RenderModels, APictureOfNothingIsAWarning) {
  const auto pbrt = [](const std::string& world) {
    return outcome_of({{"a.pbrt", "Camera \"perspective\"\nWorldBegin\n" + world}}, "a.pbrt");
  };
  const std::string sky = "LightSource \"infinite\"\n", shape = "Shape \"sphere\"\n";
  expect_warning(pbrt(sky + "Translate 0 0 -5 " + shape), "no surface is in the camera's sight");
  expect_warning(pbrt(sky + "Translate 0 9 5 " + shape), "no surface is in the camera's sight");
  expect_warning(pbrt("LightSource \"point\" \"rgb I\" [0 0 0] Translate 0 0 5 " + shape),
                 "the picture is black");
  // From inside of a closed shape, whose sky is outside.
  expect_warning(pbrt(sky + "Material \"diffuse\"\n" + shape), "the picture is black");
}

TEST(RenderModels, ASmallModelIsSeen) {
  const Outcome outcome = outcome_of({{"a.obj", triangle_of_size("1e-4")}}, "a.obj");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.messages.find("warning"), std::string::npos) << outcome.messages;
}

TEST(RenderClassic, ACameraThatWasAskedForSeesSomethingOrWarns) {
  expect_warning(outcome_of({}, "nice", {"--orbit=0,90,1e6"}),
                 "no surface is in the camera's sight");
  for (const Words& more : {Words{}, {"--orbit=0,90,10"}}) {
    const Outcome outcome = outcome_of({}, "nice", more);
    EXPECT_EQ(outcome.messages.find("warning"), std::string::npos) << outcome.messages;
  }
  EXPECT_EQ(outcome_of({}, "empty", {"--orbit=0,90,1e6"}).messages.find("warning"),
            std::string::npos);
}

TEST(RenderClassic, OptionsThatDoNotApplyAreRefused) {
  for (const std::string option :
       {"--transparent", "--rotate=9", "--filter=box", "--clamp-indirect=1", "--time=1",
        "--variant=a", "--scene=0", "--point-radius=1"}) {
    expect_refusal(outcome_of({}, "nice", {option}), 64,
                   option.substr(0, option.find('=')) + ": does not apply to");
  }
  EXPECT_EQ(
      outcome_of({}, "nice", {"--environment=studio", "--transparent", "--rotate=9"}).exit_code, 0);
}

// Two pixels, the second with these bytes in its red channel.
std::string float_map(const std::string& red) {
  const std::string zero(4, '\0');
  return "PF\n2 1\n-1\n" + zero + zero + zero + red + zero + zero;
}

TEST(RenderModels, AnEnvironmentThatIsNotFiniteIsRefused) {
  const std::string triangle = triangle_of_size("1");
  const std::string not_a_number("\x00\x00\xc0\x7f", 4), infinite("\x00\x00\x80\x7f", 4),
      one("\x00\x00\x80\x3f", 4);
  for (const std::string& red : {not_a_number, infinite}) {
    expect_refusal(outcome_of({{"a.obj", triangle}, {"sky.pfm", float_map(red)}}, "a.obj",
                              {"--environment=sky.pfm"}),
                   65, "sky.pfm: the pixel in column 1, row 0");
  }
  EXPECT_EQ(outcome_of({{"a.obj", triangle}, {"sky.pfm", float_map(one)}}, "a.obj",
                       {"--environment=sky.pfm"})
                .exit_code,
            0);
}

TEST(RenderModels, TexelsThatAreNotFiniteAreRefusedOrBlack) {
  const std::map<std::string, std::string> files = {
      {"a.pbrt",
       "Camera \"perspective\"\nWorldBegin\n"
       "LightSource \"infinite\" \"string filename\" \"sky.pfm\"\n"
       "Translate 0 0 5 Shape \"sphere\"\n"},
      {"sky.pfm", float_map(std::string("\x00\x00\xc0\x7f", 4))}};
  expect_refusal(outcome_of(files, "a.pbrt"), 65, "texels of image 0 are not finite");
  expect_warning(outcome_of(files, "a.pbrt", {"--keep-going"}), "they are black");
}

TEST(RenderModels, SamplesBrighterThanTheFilmAreCounted) {
  const auto lamp = [](const std::string& scale, const Words& more) {
    return outcome_of({{"a.pbrt",
                        "Camera \"perspective\"\nWorldBegin\n"
                        "AreaLightSource \"diffuse\" \"rgb L\" [1 1 1] \"float scale\" " +
                            scale + " Translate 0 0 5 Shape \"sphere\"\n"}},
                      "a.pbrt", more);
  };
  expect_warning(lamp("1e5", {}), "samples were brighter than 16384");
  EXPECT_EQ(lamp("1e4", {}).messages.find("brighter"), std::string::npos);
}

TEST(RenderModels, AnExposureThatLeavesNoLightIsAWarning) {
  const std::map<std::string, std::string> files = {{"a.obj", triangle_of_size("1")}};
  expect_warning(outcome_of(files, "a.obj", {"--exposure=-30"}),
                 "an exposure of -30 stops leaves no light");
  EXPECT_EQ(outcome_of(files, "a.obj", {"--exposure=-2"}).messages.find("warning"),
            std::string::npos);
}

// The warning and the report for scripts name the same figure.
TEST(RenderModels, WhatTheClampTookIsOneFigure) {
  const TestFolder folder;
  folder.write("a.pbrt",
               "Camera \"perspective\"\nWorldBegin\nLightSource \"infinite\"\n"
               "Translate 0 0 3 Shape \"sphere\"\nTranslate 0.9 0.5 0 Shape \"sphere\"\n");
  const auto result =
      folder.run({"dapple", "render", "a.pbrt", "-o", "a.png", "--spp=64", "--width=16",
                  "--height=12", "--clamp-indirect=0.001", "--json", "--quiet"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string before = "clamping took ";
  const std::size_t at = result.err.find(before);
  ASSERT_NE(at, std::string::npos) << result.err;
  const double warned = std::stod(result.err.substr(at + before.size()));
  EXPECT_NEAR(json::parse(result.out)["clamped_radiance"].get<double>(), warned, 0.01 * warned);
}

TEST(RenderModels, AnInputIsNotReplaced) {
  const TestFolder folder;
  folder.write("a.obj", triangle_of_size("1"));
  ASSERT_EQ(folder.run({"dapple", "convert", "a.obj", "-o", "a.scene", "-q"}).exit_code, 0);
  folder.write("sky.pfm", float_map(std::string(4, '\0')));
  const Words commands[] = {
      {"dapple", "render", "a.scene", "-o", "./a.scene"},
      {"dapple", "render", "a.obj", "-o", "a.obj"},
      {"dapple", "convert", "a.obj", "-o", "a.obj"},
      {"dapple", "render", "a.obj", "-o", "sky.pfm", "--environment=sky.pfm"}};
  for (const Words& command : commands) {
    const std::string before = folder.read(command[4]);
    const auto result = folder.run(command);
    EXPECT_EQ(result.exit_code, 64) << result.err;
    EXPECT_NE(result.err.find("would replace an input"), std::string::npos) << result.err;
    EXPECT_EQ(folder.read(command[4]), before);
  }
}

}  // namespace
}  // namespace dapple
