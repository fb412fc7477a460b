// The classic programs from outside: output, exit codes, files.
#include <gtest/gtest.h>

#include <regex>

#include "scene/named_scenes.h"
#include "scene_file/writer.h"
#include "tests/apps/run_program.h"

namespace dapple {
namespace {

using Words = std::vector<std::string>;

constexpr const char* kSeconds = "[0-9]+\\.[0-9]{6}s\\.\n";

bool matches(const std::string& text, const std::string& pattern) {
  return std::regex_match(text, std::regex(pattern));
}

TEST(ClassicRender, PrintsItsTimesAndNothingElse) {
  const TestFolder folder;
  const auto ray = folder.run({"ray", "a.ppm", "8", "6", "2"});
  EXPECT_EQ(ray.exit_code, 0);
  EXPECT_EQ(ray.err, "");
  EXPECT_TRUE(matches(ray.out, std::string("Rendering in ") + kSeconds)) << ray.out;
  const auto bvh = folder.run({"ray_bvh", "b.ppm", "8", "6", "2", "nice"});
  EXPECT_EQ(bvh.exit_code, 0);
  EXPECT_EQ(bvh.err, "");
  EXPECT_TRUE(matches(
      bvh.out, std::string("Scene BVH construction in ") + kSeconds + "Rendering in " + kSeconds))
      << bvh.out;
  EXPECT_EQ(folder.names(), (Words{"a.ppm", "b.ppm"}));
}

TEST(ClassicRender, SaysThatItReadsAFile) {
  const TestFolder folder;
  ASSERT_EQ(folder.run({"store_scene", "my.scene", "rgbbox"}).exit_code, 0);
  const auto ray = folder.run({"ray", "a.ppm", "8", "6", "1", "my.scene"});
  EXPECT_EQ(ray.exit_code, 0) << ray.err;
  EXPECT_TRUE(matches(ray.out, std::string("Reading scene from my\\.scene\\.\\.\\.\n") +
                                   "Rendering in " + kSeconds))
      << ray.out;
  const auto bvh = folder.run({"ray_bvh", "b.ppm", "8", "6", "1", "./my.scene"});
  EXPECT_TRUE(matches(bvh.out, std::string("Reading scene from \\./my\\.scene\\.\\.\\.\n") +
                                   "Scene BVH construction in " + kSeconds + "Rendering in " +
                                   kSeconds))
      << bvh.out;
}

TEST(ClassicRender, ANameComesBeforeAFileOfThatName) {
  const TestFolder folder;
  ASSERT_EQ(folder.run({"store_scene", "nice", "rgbbox"}).exit_code, 0);
  EXPECT_EQ(folder.run({"ray_bvh", "name.ppm", "8", "6", "1", "nice"}).out.find("Reading"),
            std::string::npos);
  folder.run({"ray_bvh", "default.ppm", "8", "6", "1"});
  folder.run({"ray_bvh", "file.ppm", "8", "6", "1", "./nice"});
  folder.run({"ray_bvh", "rgbbox.ppm", "8", "6", "1", "rgbbox"});
  EXPECT_EQ(folder.read("name.ppm"), folder.read("default.ppm"));
  EXPECT_EQ(folder.read("file.ppm"), folder.read("rgbbox.ppm"));
  EXPECT_NE(folder.read("file.ppm"), folder.read("name.ppm"));
}

TEST(ClassicRender, AStoredSceneGivesTheSamePicture) {
  const TestFolder folder;
  for (const std::string scene : {"empty", "irreg", "nice", "rgbbox"}) {
    ASSERT_EQ(folder.run({"store_scene", "stored", scene}).exit_code, 0);
    ASSERT_EQ(folder.run({"dapple", "convert", scene, "-o", "with_bvh"}).exit_code, 0);
    folder.run({"ray_bvh", "direct", "20", "15", "2", scene});
    folder.run({"ray_bvh", "from_file", "20", "15", "2", "stored"});
    folder.run({"ray_bvh", "from_bvh", "20", "15", "2", "with_bvh"});
    ASSERT_FALSE(folder.read("direct").empty());
    EXPECT_EQ(folder.read("direct"), folder.read("from_file")) << scene;
    EXPECT_EQ(folder.read("direct"), folder.read("from_bvh")) << scene;
  }
}

TEST(ClassicRender, ACameraThatLooksNowhereIsNamedWithItsFile) {
  const TestFolder folder;
  Scene scene = *make_named_scene("nice");
  scene.camera.look_at = scene.camera.look_from;
  ASSERT_TRUE(store_scene_file(folder.path("blind").string(), scene));
  const auto result = folder.run({"ray_bvh", "out", "7", "5", "1", "blind"});
  EXPECT_NE(result.exit_code, 0);
  EXPECT_NE(result.err.find("blind: camera: it looks at its own position"), std::string::npos)
      << result.err;
}

TEST(ClassicRender, WritesBinaryPpmWhateverTheName) {
  const TestFolder folder;
  for (const std::string name : {"picture", "picture.jpg", "picture.ppm"}) {
    ASSERT_EQ(folder.run({"ray", name, "7", "5", "1", "empty"}).exit_code, 0);
    const std::string bytes = folder.read(name);
    EXPECT_TRUE(bytes.starts_with("P6\n7 5\n255\n")) << name;
    EXPECT_EQ(bytes.size(), std::string("P6\n7 5\n255\n").size() + 7 * 5 * 3);
  }
}

TEST(ClassicRender, FourEndingsSelectAnotherFormat) {
  const TestFolder folder;
  const std::vector<std::pair<std::string, std::string>> magics = {
      {"a.png", "\x89PNG\r\n"}, {"a.exr", "\x76\x2f\x31\x01"}, {"a.pfm", "PF\n"}, {"a.hdr", "#?"}};
  for (const auto& [name, magic] : magics) {
    ASSERT_EQ(folder.run({"ray", name, "7", "5", "1", "empty"}).exit_code, 0);
    EXPECT_TRUE(folder.read(name).starts_with(magic)) << name;
  }
}

// The sky's colour at the zenith is (0.5, 0.7, 1) and the curve of the file is a square root:
// every row is between that and white.
TEST(ClassicRender, UsesASquareRootAsTransfer) {
  const TestFolder folder;
  ASSERT_EQ(folder.run({"ray", "sky", "1", "1", "64", "empty"}).exit_code, 0);
  const std::string bytes = folder.read("sky");
  const auto channel = [&](std::size_t i) {
    return static_cast<unsigned char>(bytes[bytes.size() - 3 + i]);
  };
  // With t the mean of (d.y + 1) / 2, red is sqrt(1 - 0.5 t) and green sqrt(1 - 0.3 t).
  const double red = channel(0) / 255.0, green = channel(1) / 255.0;
  EXPECT_NEAR((1 - green * green) / (1 - red * red), 0.6, 0.02);
  EXPECT_EQ(channel(2), 255);
}

TEST(ClassicRender, RayAndRayBvhWriteTheSameBytesForAnyNumberOfThreads) {
  const TestFolder folder;
  for (const std::string scene : {"nice", "rgbbox", "spheres:300"}) {
    ASSERT_EQ(folder.run({"ray", "reference", "70", "50", "5", scene}).exit_code, 0);
    const std::string reference = folder.read("reference");
    for (const std::string threads : {"1", "2", "3", "7"}) {
      for (const std::string program : {"ray", "ray_bvh"}) {
        RunOptions options;
        options.environment["OMP_NUM_THREADS"] = threads;
        ASSERT_EQ(folder.run({program, "picture", "70", "50", "5", scene}, options).exit_code, 0);
        EXPECT_EQ(folder.read("picture"), reference) << program << ' ' << scene << ' ' << threads;
      }
    }
  }
}

TEST(ClassicRender, HonoursTheVariablesOfOpenMp) {
  const TestFolder folder;
  for (const std::string threads : {"1", "3", "7"}) {
    RunOptions options;
    options.environment["OMP_NUM_THREADS"] = threads;
    const auto version = folder.run({"ray", "--version"}, options);
    EXPECT_NE(version.out.find("threads    " + threads + " "), std::string::npos) << version.out;
  }
}

TEST(ClassicPrograms, WrongUsageIsExit2WithAUsageLine) {
  const TestFolder folder;
  const std::vector<Words> commands = {
      {"ray"},
      {"ray", "x.ppm", "8", "6"},
      {"ray", "x.ppm", "8", "6", "1", "nice", "more"},
      {"ray", "x.ppm", "8", "6", "1", "rgbbox:0"},
      {"ray", "x.ppm", "8", "6", "1", "nice:5"},
      {"ray", "--fast", "x.ppm", "8", "6", "1"},
      {"ray", "x.ppm", "1048576", "1048576", "1"},
      {"ray_bvh"},
      {"store_scene"},
      {"store_scene", "x.scene"},
      {"store_scene", "x.scene", "nice", "more"},
      {"describe_scene"},
      {"describe_scene", "a", "b"},
      {"describe_scene", "--no-such-option", "a"},
  };
  for (const Words& command : commands) {
    const auto result = folder.run(command);
    EXPECT_EQ(result.exit_code, 2) << testing::PrintToString(command);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find("usage: " + command[0] + " "), std::string::npos) << result.err;
  }
  EXPECT_TRUE(folder.names().empty());
}

TEST(ClassicPrograms, SizesAreCheckedWhole) {
  const TestFolder folder;
  for (const std::string bad : {"12x", "0", "-3", "1e9", "99999999999", "+5", " 5", "5 ", "",
                                "0x10", "1.0", "18446744073709551617"}) {
    for (int place = 0; place < 3; ++place) {
      Words command = {"ray_bvh", "x.ppm", "8", "6", "1"};
      command[static_cast<std::size_t>(2 + place)] = bad;
      const auto result = folder.run(command);
      EXPECT_EQ(result.exit_code, 2) << '"' << bad << '"';
      EXPECT_NE(result.err.find("'" + bad + "'"), std::string::npos) << result.err;
    }
  }
  EXPECT_TRUE(folder.names().empty());
}

TEST(ClassicPrograms, HelpGoesToStandardOutput) {
  const TestFolder folder;
  for (const std::string program : {"ray", "ray_bvh", "store_scene", "describe_scene"}) {
    const auto result = folder.run({program, "--help"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.err, "");
    EXPECT_TRUE(result.out.starts_with("usage: " + program + " ")) << result.out;
  }
}

}  // namespace
}  // namespace dapple
