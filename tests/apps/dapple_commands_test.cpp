// `dapple` from outside.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "scene/named_scenes.h"
#include "scene_file/writer.h"
#include "tests/apps/run_program.h"

namespace dapple {
namespace {

using Words = std::vector<std::string>;
using nlohmann::json;

Words small_render(const std::string& scene, const std::string& output, const Words& more = {}) {
  Words words = {"dapple", "render", scene, "-o", output, "--width=24", "--height=18", "--spp=3"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(Dapple, UsageErrorsAreExit64WithAHint) {
  const TestFolder folder;
  const std::vector<Words> commands = {
      {"dapple"},
      {"dapple", "no-such-command"},
      {"dapple", "--no-such-option"},
      {"dapple", "render"},
      {"dapple", "render", "nice"},
      {"dapple", "render", "-o", "x.png"},
      {"dapple", "render", "nice", "-o", "x.png", "more"},
      {"dapple", "render", "nice", "-o", "x.png", "--width", "0"},
      {"dapple", "render", "nice", "-o", "x.png", "--width", "1048576", "--height", "1048576"},
      {"dapple", "render", "nice", "-o", "x.png", "--accel", "embree"},
      {"dapple", "render", "irreg:x", "-o", "x.png"},
      {"dapple", "convert", "nice", "-o", "x", "--bvh", "--no-bvh"},
      {"dapple", "compare", "a.png"},
      {"dapple", "scenes", "more"},
  };
  for (const Words& command : commands) {
    const auto result = folder.run(command);
    EXPECT_EQ(result.exit_code, 64) << testing::PrintToString(command);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find("--help)\n"), std::string::npos) << result.err;
  }
  EXPECT_TRUE(folder.names().empty());
}

TEST(Dapple, AMistypedCommandIsGuessed) {
  const TestFolder folder;
  EXPECT_NE(folder.run({"dapple", "rendr"}).err.find("did you mean render?"), std::string::npos);
}

TEST(Dapple, HelpAndVersion) {
  const TestFolder folder;
  for (const Words& command : {Words{"dapple", "--help"}, Words{"dapple", "render", "--help"},
                               Words{"dapple", "compare", "-h"}}) {
    const auto result = folder.run(command);
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_TRUE(result.out.starts_with("usage: dapple")) << result.out;
    EXPECT_NE(result.out.find("\nExamples:\n"), std::string::npos);
  }
  const auto version = folder.run({"dapple", "--version"});
  EXPECT_EQ(version.exit_code, 0);
  for (const std::string part : {"dapple ", "ISA ", "compiler ", "OpenMP", "CLI11 ", "fmt "}) {
    EXPECT_NE(version.out.find(part), std::string::npos) << version.out;
  }
}

TEST(Dapple, TheInstructionSetCanBeForced) {
  const TestFolder folder;
  RunOptions options;
  options.environment["DAPPLE_ISA"] = "portable";
  const auto portable = folder.run(small_render("rgbbox", "a.pfm", {"--json"}), options);
  ASSERT_EQ(portable.exit_code, 0) << portable.err;
  EXPECT_EQ(json::parse(portable.out)["isa"], "portable");
  ASSERT_EQ(folder.run(small_render("rgbbox", "b.pfm")).exit_code, 0);
  EXPECT_EQ(folder.read("a.pfm"), folder.read("b.pfm"));
  options.environment["DAPPLE_ISA"] = "no-such-level";
  EXPECT_EQ(folder.run(small_render("rgbbox", "c.pfm"), options).exit_code, 64);
}

TEST(Render, WritesOneLineUnlessQuiet) {
  const TestFolder folder;
  const auto loud = folder.run(small_render("nice", "a.png"));
  EXPECT_EQ(loud.exit_code, 0);
  EXPECT_EQ(loud.out, "");
  EXPECT_TRUE(loud.err.starts_with("a.png: 24 x 18 pixels, 3 samples each, rendered in "))
      << loud.err;
  const auto quiet = folder.run(small_render("nice", "b.png", {"-q"}));
  EXPECT_EQ(quiet.exit_code, 0);
  EXPECT_EQ(quiet.out + quiet.err, "");
  EXPECT_EQ(folder.read("a.png"), folder.read("b.png"));
}

TEST(Render, ReportsAsJson) {
  const TestFolder folder;
  const auto result = folder.run(small_render(
      "rgbbox", "a.png", {"--json", "--seed=9", "--threads=3", "--accel=median", "--depth=2"}));
  ASSERT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  const json report = json::parse(result.out);
  EXPECT_EQ(report["scene"], "rgbbox");
  EXPECT_EQ(report["output"], "a.png");
  EXPECT_EQ(report["width"], 24);
  EXPECT_EQ(report["height"], 18);
  EXPECT_EQ(report["spp"], 3);
  EXPECT_EQ(report["depth"], 2);
  EXPECT_EQ(report["seed"], 9);
  EXPECT_EQ(report["threads"], 3);
  EXPECT_EQ(report["accel"], "median");
  EXPECT_EQ(report["dropped_samples"], 0);
  for (const char* time : {"load_seconds", "build_seconds", "render_seconds", "write_seconds"}) {
    EXPECT_GE(report[time].get<double>(), 0);
  }
}

TEST(Render, ThreadsComeFromTheOptionElseFromOpenMp) {
  const TestFolder folder;
  RunOptions options;
  options.environment["OMP_NUM_THREADS"] = "5";
  const auto threads = [&](const Words& more) {
    return json::parse(folder.run(small_render("empty", "a.png", more), options).out)["threads"];
  };
  EXPECT_EQ(threads({"--json"}), 5);
  EXPECT_EQ(threads({"--json", "--threads=0"}), 5);
  EXPECT_EQ(threads({"--json", "--threads=2"}), 2);
}

TEST(Render, TheSameBytesForAnyThreadsAndStructure) {
  const TestFolder folder;
  ASSERT_EQ(folder.run(small_render("spheres:200", "reference.pfm")).exit_code, 0);
  for (const std::string accel : {"linear", "median", "fast"}) {
    for (const std::string threads : {"1", "2", "3", "7"}) {
      const auto result = folder.run(
          small_render("spheres:200", "a.pfm", {"--accel", accel, "--threads", threads}));
      ASSERT_EQ(result.exit_code, 0);
      EXPECT_EQ(folder.read("a.pfm"), folder.read("reference.pfm")) << accel << ' ' << threads;
    }
  }
  ASSERT_EQ(folder.run(small_render("spheres:200", "a.pfm", {"--seed=1"})).exit_code, 0);
  EXPECT_NE(folder.read("a.pfm"), folder.read("reference.pfm"));
}

TEST(Render, OptionsReachTheFile) {
  const TestFolder folder;
  const auto size_of = [&](const std::string& name, const Words& more) {
    EXPECT_EQ(folder.run(small_render("nice", name, more)).exit_code, 0);
    return folder.read(name).size();
  };
  EXPECT_LT(size_of("a.png", {"--bits=8"}), size_of("b.png", {"--bits=16"}));
  EXPECT_EQ(folder.read("a.png")[24], 8);  // the bit depth of a PNG header
  EXPECT_EQ(folder.read("b.png")[24], 16);
  EXPECT_LT(size_of("a.exr", {}), size_of("b.exr", {"--exr-type=float"}));
  size_of("a.ppm", {"--transfer=gamma2"});
  ASSERT_EQ(folder.run({"ray", "b.ppm", "24", "18", "3"}).exit_code, 0);
  EXPECT_EQ(folder.read("a.ppm"), folder.read("b.ppm"));
  size_of("c.ppm", {});
  EXPECT_NE(folder.read("c.ppm"), folder.read("b.ppm"));
}

// An albedo beyond single precision makes paths that carry no finite light.
TEST(Render, WarnsOfSamplesThatAreNotFinite) {
  const TestFolder folder;
  Scene scene;
  scene.add_sphere({{0, 0, -3}, 1}, scene.add_material(Lambertian{{1e300, 1, 1}}));
  ASSERT_TRUE(store_scene_file(folder.path("hot").string(), scene));
  const auto result = folder.run(small_render("hot", "a.png", {"-q", "--json"}));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_GT(json::parse(result.out)["dropped_samples"].get<int>(), 0);
  EXPECT_TRUE(result.err.starts_with("dapple: warning: ")) << result.err;
}

TEST(Render, WarnsOfSamplesBrighterThanTheFilm) {
  const TestFolder folder;
  Scene scene;
  scene.add_sphere({{0, 0, -3}, 1}, scene.add_material(Lambertian{{1e6, 1, 1}}));
  ASSERT_TRUE(store_scene_file(folder.path("bright").string(), scene));
  const auto result = folder.run(small_render("bright", "a.png", {"-q", "--json"}));
  EXPECT_EQ(result.exit_code, 0);
  const auto count = json::parse(result.out)["cut_samples"].get<int>();
  EXPECT_GT(count, 0);
  EXPECT_EQ(result.err, "dapple: warning: " + std::to_string(count) +
                            " samples were brighter than 16384 and count as that bright\n");
}

TEST(Convert, StoresWithAndWithoutBvh) {
  const TestFolder folder;
  ASSERT_EQ(folder.run({"dapple", "convert", "irreg", "-o", "with", "-q"}).exit_code, 0);
  ASSERT_EQ(folder.run({"dapple", "convert", "irreg", "-o", "without", "--no-bvh"}).exit_code, 0);
  ASSERT_EQ(folder.run({"store_scene", "stored", "irreg"}).exit_code, 0);
  EXPECT_EQ(folder.read("without"), folder.read("stored"));
  const auto nodes = [&](const std::string& name) {
    return json::parse(folder.run({"dapple", "info", "--json", name}).out)["counts"]["bvh_nodes"]
        .get<int>();
  };
  EXPECT_GT(nodes("with"), 0);
  EXPECT_EQ(nodes("without"), 0);
  // There and back again.
  ASSERT_EQ(folder.run({"dapple", "convert", "with", "-o", "back", "--no-bvh"}).exit_code, 0);
  EXPECT_EQ(folder.read("back"), folder.read("without"));
  ASSERT_EQ(folder.run({"dapple", "convert", "without", "-o", "again", "--bvh"}).exit_code, 0);
  EXPECT_EQ(folder.read("again"), folder.read("with"));
}

TEST(Convert, TheFileIsTheSameForAnyNumberOfThreads) {
  const TestFolder folder;
  ASSERT_EQ(folder.run({"dapple", "convert", "spheres:5000", "-o", "one", "-j1"}).exit_code, 0);
  for (const std::string threads : {"2", "3", "7"}) {
    ASSERT_EQ(
        folder.run({"dapple", "convert", "spheres:5000", "-o", "many", "-j" + threads}).exit_code,
        0);
    EXPECT_EQ(folder.read("many"), folder.read("one")) << threads;
  }
}

TEST(Trust, SkipsTheChecksumsOnly) {
  const TestFolder folder;
  ASSERT_EQ(folder.run({"store_scene", "good", "rgbbox"}).exit_code, 0);
  // One bit of the last sphere's radius or centre: another valid number.
  std::string bytes = folder.read("good");
  const std::string before = folder.run({"dapple", "info", "good"}).out;
  bool accepted = false;
  for (std::size_t i = bytes.size() / 2; i < bytes.size() && !accepted; i += 8) {
    std::string flipped = bytes;
    flipped[i] = static_cast<char>(flipped[i] ^ 1);
    folder.write("flipped", flipped);
    ASSERT_EQ(folder.run({"dapple", "info", "flipped"}).exit_code, 65);
    const auto trusted = folder.run({"dapple", "info", "--trust", "flipped"});
    accepted = trusted.exit_code == 0;
    EXPECT_TRUE(accepted || trusted.exit_code == 65);
  }
  EXPECT_TRUE(accepted);
}

TEST(Scenes, ListsAllOfThem) {
  const TestFolder folder;
  const std::string text = folder.run({"dapple", "scenes"}).out;
  const json list = json::parse(folder.run({"dapple", "scenes", "--json"}).out);
  ASSERT_EQ(list.size(), named_scenes().size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    EXPECT_EQ(list[i]["name"], named_scenes()[i].name);
    EXPECT_NE(text.find(std::string(named_scenes()[i].summary)), std::string::npos);
  }
}

TEST(Bench, MeasuresEveryStructureThatIsAskedFor) {
  const TestFolder folder;
  const auto result = folder.run({"dapple", "bench", "rgbbox", "-a", "linear", "-a", "median", "-a",
                                  "fast", "--width=40", "--height=30", "--repeat=3", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json report = json::parse(result.out);
  EXPECT_EQ(report["objects"], 400);
  ASSERT_EQ(report["accels"].size(), 3u);
  const std::vector<std::string> names = {"linear", "median", "fast"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const json& figures = report["accels"][i];
    EXPECT_EQ(figures["accel"], names[i]);
    EXPECT_EQ(figures["coherent"]["rays"], 1200);
    // All structures find the same hits, so the rays that leave them are the same.
    EXPECT_EQ(figures["incoherent"]["rays"], report["accels"][0]["incoherent"]["rays"]);
    EXPECT_GT(figures["coherent"]["closest_hit_per_second"].get<double>(), 0);
    EXPECT_GT(figures["incoherent"]["any_hit_per_second"].get<double>(), 0);
    EXPECT_GT(figures["bytes"].get<std::size_t>(), 0u);
  }
  const std::string text = folder.run({"dapple", "bench", "empty", "--width=8", "--height=8"}).out;
  EXPECT_NE(text.find("coherent rays             64\n"), std::string::npos) << text;
  EXPECT_NE(text.find("incoherent rays           0\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace dapple
