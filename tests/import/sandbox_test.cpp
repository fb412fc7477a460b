// No name leads out of the folder of the file that holds it.
#include "import/sandbox.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/util/temporary_folder.h"

namespace dapple {
namespace {

class SandboxTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories((folder_ / "model/textures"));
    write("secret", "outside");
    write("model/a.bin", "inside");
    write("model/textures/b.bin", "below");
  }
  void write(const std::string& name, const std::string& text) { put_file(folder_ / name, text); }
  std::string read(const std::string& name) {
    auto sandbox = Sandbox::around((folder_ / "model/scene.gltf"));
    EXPECT_TRUE(sandbox.has_value());
    const auto file = sandbox->open(name);
    if (!file) return "error: " + to_string(file.error());
    return {reinterpret_cast<const char*>(file->bytes().data()), file->bytes().size()};
  }

  TemporaryFolder folder_;
};

TEST_F(SandboxTest, FilesInAndBelowTheFolderOpen) {
  EXPECT_EQ(read("a.bin"), "inside");
  EXPECT_EQ(read("textures/b.bin"), "below");
  EXPECT_EQ(read("textures/../a.bin"), "inside");
}

TEST_F(SandboxTest, NothingOutsideOpens) {
  std::filesystem::create_symlink("../secret", (folder_ / "model/link"));
  std::filesystem::create_symlink("..", (folder_ / "model/up"));
  for (const std::string& name :
       {std::string("../secret"), std::string("textures/../../secret"), (folder_ / "secret"),
        std::string("link"), std::string("up/secret"), std::string("/etc/hostname")}) {
    EXPECT_NE(read(name).find("outside the folder"), std::string::npos) << name;
  }
}

TEST_F(SandboxTest, WhatIsNoFileIsNamed) {
  EXPECT_NE(read("missing.bin").find("missing.bin: cannot open"), std::string::npos);
  EXPECT_NE(read("textures").find("textures: cannot open"), std::string::npos);
  EXPECT_NE(read("").find("not the name of a file"), std::string::npos);
  EXPECT_NE(read(std::string("a.bin\0x", 7)).find("not the name of a file"), std::string::npos);
}

}  // namespace
}  // namespace dapple
