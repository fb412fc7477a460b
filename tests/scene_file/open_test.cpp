// Scenes from the file system: what opens, and what the errors say.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "scene/named_scenes.h"
#include "scene_file/mapped_scene.h"
#include "scene_file/scene_source.h"
#include "scene_file/writer.h"
#include "tests/scene_file/scene_bytes.h"
#include "util/mapped_ranges.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

class Open : public testing::Test {
 protected:
  Open() {
    std::string pattern = (fs::temp_directory_path() / "scene_file_test.XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  ~Open() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string write(const std::string& name, const std::string& content) const {
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
  }
  static void expect_error(const std::string& file, Errc code, const std::string& reason) {
    const auto source = SceneSource::open(file);
    ASSERT_FALSE(source) << file;
    EXPECT_EQ(source.error().code, code);
    EXPECT_NE(source.error().message.find(reason), std::string::npos) << source.error().message;
    EXPECT_NE(to_string(source.error()).find(file), std::string::npos);
    EXPECT_EQ(to_string(source.error()).find('\n'), std::string::npos);
  }

  fs::path folder_;
};

TEST_F(Open, AStoredSceneIsTheScene) {
  for (const char* name : {"empty", "nice", "rgbbox", "irreg"}) {
    const Scene scene = *make_named_scene(name);
    ASSERT_TRUE(store_scene_file(path(name), scene));
    const auto source = SceneSource::open(path(name));
    ASSERT_TRUE(source) << to_string(source.error());
    EXPECT_TRUE(test::same_scene(source->view(), scene));
  }
}

TEST_F(Open, AViewSurvivesMovingItsOwner) {
  ASSERT_TRUE(store_scene_file(path("a"), *make_named_scene("nice")));
  auto source = SceneSource::open(path("a"));
  ASSERT_TRUE(source);
  const SceneSource moved = std::move(*source);
  EXPECT_TRUE(test::same_scene(moved.view(), *make_named_scene("nice")));
  const SceneSource named = std::move(*SceneSource::open("nice"));
  EXPECT_TRUE(test::same_scene(named.view(), *make_named_scene("nice")));
}

TEST_F(Open, ANameWinsAndAPathIsAFile) {
  ASSERT_TRUE(store_scene_file(path("nice"), *make_named_scene("rgbbox")));
  const fs::path before = fs::current_path();
  fs::current_path(folder_);
  EXPECT_EQ(SceneSource::open("nice")->view().object_count(), 4u);
  EXPECT_EQ(SceneSource::open("./nice")->view().object_count(), 400u);
  fs::current_path(before);
  EXPECT_FALSE(SceneSource::is_path("nice"));
  EXPECT_FALSE(SceneSource::is_path("irreg:7"));
  EXPECT_TRUE(SceneSource::is_path("./nice"));
}

TEST_F(Open, NeitherNameNorFileListsTheNames) {
  expect_error("nise", Errc::no_input, "empty, irreg, nice, rgbbox");
  expect_error(path("missing"), Errc::no_input, "no such file");
}

TEST_F(Open, FilesThatAreNoScenes) {
  expect_error(folder_.string(), Errc::no_input, "Is a directory");
  expect_error("/dev/zero", Errc::no_input, "not a regular file");
  expect_error(write("empty_file", ""), Errc::bad_data, "empty");
  expect_error(write("text", "Hello, world\n"), Errc::bad_data, "looks like text");
  expect_error(write("picture", "P6\n1 1\n255\n..."), Errc::bad_data, "PPM image");
  expect_error(write("png", "\x89PNG\r\n\x1a\n...."), Errc::bad_data, "PNG image");
  expect_error(write("json", "  {\"asset\": {}}"), Errc::bad_data, "JSON");
  expect_error(write("elf",
                     "\x7f"
                     "ELF\x02\x01"),
               Errc::bad_data, "ELF program");
  expect_error(write("zeros", std::string(9000, '\0')), Errc::bad_data, "begins with zeros");
  expect_error(write("noise", "\x01\xfe\x03 and on"), Errc::bad_data, "no kind that is known");
  expect_error(write("text_mode",
                     "\x89"
                     "DPL\n\x1a\n"),
               Errc::bad_data, "transfer in text mode");
  expect_error(write("stub",
                     "\x89"
                     "DPL\r\n"),
               Errc::bad_data, "inside its header");
}

TEST_F(Open, APipeDoesNotHang) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  expect_error(path("pipe"), Errc::no_input, "not a regular file");
}

TEST_F(Open, ALinkThatLeadsNowhereSaysSo) {
  fs::create_symlink(path("nowhere"), path("link"));
  expect_error(path("link"), Errc::no_input, "No such file");
}

TEST_F(Open, AFileThatMayNotBeRead) {
  const std::string file = write("secret", "x");
  ::chmod(file.c_str(), 0);
  if (::access(file.c_str(), R_OK) == 0) {  // the superuser may read anything
    expect_error(file, Errc::bad_data, "looks like text");
  } else {
    expect_error(file, Errc::no_input, "Permission denied");
  }
}

TEST_F(Open, ABrokenFileIsNamedWithTheByte) {
  auto bytes = test::scene_bytes(*make_named_scene("rgbbox"));
  bytes[bytes.size() / 2] ^= std::byte{16};
  const auto* text = reinterpret_cast<const char*>(bytes.data());
  const std::string file = write("broken", std::string(text, bytes.size()));
  expect_error(file, Errc::bad_data, "at byte ");
  expect_error(file, Errc::bad_data, "checksum of section SPHR");
}

TEST_F(Open, StoringReplacesWholeOrNotAtAll) {
  const std::string file = write("target", "precious");
  Scene broken = *make_named_scene("nice");
  broken.sphere_materials[0] = MaterialId{99};
  EXPECT_FALSE(store_scene_file(file, broken));
  EXPECT_EQ(fs::file_size(file), 8u);
  EXPECT_FALSE(store_scene_file(path("no/such/folder"), *make_named_scene("nice")));
  EXPECT_FALSE(store_scene_file(folder_.string(), *make_named_scene("nice")));
  EXPECT_FALSE(store_scene_file("/dev/full", *make_named_scene("nice")));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
  EXPECT_TRUE(store_scene_file(file, *make_named_scene("nice")));
  EXPECT_TRUE(SceneSource::open(file));
}

// What a file's truncation does to a program that reads it, and to one that asked for the handler.
using OpenDeathTest = Open;

TEST_F(OpenDeathTest, TruncationWhileMappedBecomesAnExitCode) {
  const std::string file = path("shrinking");
  ASSERT_TRUE(store_scene_file(file, *make_named_scene("spheres:20000")));
  const auto read_after_truncation = [&] {
    exit_when_mapped_file_shrinks(74);
    const auto scene = MappedScene::open(file);
    fs::resize_file(file, 100);
    volatile double last = scene->view().spheres.back().radius;
    static_cast<void>(last);
    std::_Exit(0);
  };
  EXPECT_EXIT(read_after_truncation(), testing::ExitedWithCode(74),
              "shrinking: the file was truncated while it was being read");
}

TEST_F(OpenDeathTest, TheLibraryInstallsNoHandlerByItself) {
  const std::string file = path("shrinking");
  ASSERT_TRUE(store_scene_file(file, *make_named_scene("spheres:20000")));
  struct sigaction before {
  }, after{};
  ASSERT_EQ(::sigaction(SIGBUS, nullptr, &before), 0);
  const auto scene = MappedScene::open(file);
  ASSERT_TRUE(scene);
  ASSERT_EQ(::sigaction(SIGBUS, nullptr, &after), 0);
  EXPECT_EQ(after.sa_handler, before.sa_handler);
}

}  // namespace
}  // namespace dapple
