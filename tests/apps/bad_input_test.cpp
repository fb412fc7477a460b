// Input and output that cannot work: one clear line, the right exit code, nothing left behind.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>

#include "tests/apps/run_program.h"

namespace dapple {
namespace {

using Words = std::vector<std::string>;

bool is_one_line(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n') == 1 && text.back() == '\n';
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// The same attempt with a classic program and with dapple.
struct Attempt {
  Words command;
  int exit_code;
};

std::vector<Attempt> writers(const std::string& output, int dapple_exit_code) {
  return {
      {{"ray", output, "8", "6", "1"}, 1},
      {{"ray_bvh", output, "8", "6", "1"}, 1},
      {{"store_scene", output, "nice"}, 1},
      {{"dapple", "render", "nice", "-o", output, "--width=8", "--height=6"}, dapple_exit_code},
      {{"dapple", "convert", "nice", "-o", output}, dapple_exit_code},
  };
}

std::vector<Attempt> readers(const std::string& input, int dapple_exit_code) {
  return {
      {{"ray", "x.ppm", "8", "6", "1", input}, 1},
      {{"ray_bvh", "x.ppm", "8", "6", "1", input}, 1},
      {{"store_scene", "x.scene", input}, 1},
      {{"dapple", "render", input, "-o", "x.png"}, dapple_exit_code},
      {{"dapple", "convert", input, "-o", "x.scene"}, dapple_exit_code},
      {{"dapple", "info", input}, dapple_exit_code},
      {{"dapple", "bench", input}, dapple_exit_code},
  };
}

void expect_failure(const TestFolder& folder, const Attempt& attempt, const Words& parts,
                    const RunOptions& options = {}) {
  SCOPED_TRACE(testing::PrintToString(attempt.command));
  const Words before = folder.names();
  const auto result = folder.run(attempt.command, options);
  EXPECT_EQ(result.exit_code, attempt.exit_code);
  EXPECT_TRUE(is_one_line(result.err)) << result.err;
  EXPECT_TRUE(result.err.starts_with(attempt.command[0] + ": ")) << result.err;
  for (const std::string& part : parts) EXPECT_TRUE(contains(result.err, part)) << result.err;
  EXPECT_EQ(folder.names(), before);
}

TEST(BadInput, AnUnknownSceneListsTheNames) {
  const TestFolder folder;
  for (const Attempt& attempt : readers("no-such-scene", 66)) {
    expect_failure(folder, attempt,
                   {"no-such-scene", "empty", "irreg", "nice", "rgbbox", "spheres"});
  }
}

TEST(BadInput, SceneFilesThatAreNone) {
  const TestFolder folder;
  ASSERT_EQ(folder.run({"store_scene", "good", "nice"}).exit_code, 0);
  const std::string good = folder.read("good");
  folder.write("zero", "");
  folder.write("cut", good.substr(0, good.size() / 2));
  folder.write("longer", good + "x");
  folder.write("foreign", "P6\n1 1\n255\nabc");
  std::string flipped = good;
  flipped[flipped.size() - 70] = static_cast<char>(flipped[flipped.size() - 70] ^ 4);
  folder.write("flipped", flipped);
  for (const std::string name : {"zero", "cut", "longer", "foreign", "flipped"}) {
    for (const Attempt& attempt : readers(name, 65)) expect_failure(folder, attempt, {name});
    expect_failure(folder, {{"describe_scene", name}, 1}, {name});
  }
}

TEST(BadInput, SceneFilesThatCannotBeRead) {
  const TestFolder folder;
  std::filesystem::create_directory(folder.path("folder"));
  ASSERT_EQ(::mkfifo(folder.path("pipe").c_str(), 0600), 0);
  for (const std::string name : {"folder", "pipe", "/dev/null"}) {
    for (const Attempt& attempt : readers(name, 66)) expect_failure(folder, attempt, {name});
    expect_failure(folder, {{"describe_scene", name}, 1}, {name});
  }
  expect_failure(folder, {{"describe_scene", "missing"}, 1}, {"missing", "No such file"});
}

TEST(BadOutput, AFolderThatDoesNotExist) {
  const TestFolder folder;
  for (const Attempt& attempt : writers("nowhere/x.png", 73)) {
    expect_failure(folder, attempt, {"nowhere/x.png", "No such file or directory"});
  }
}

TEST(BadOutput, AFolderInsteadOfAFile) {
  const TestFolder folder;
  std::filesystem::create_directory(folder.path("folder"));
  for (const Attempt& attempt : writers("folder", 73)) {
    expect_failure(folder, attempt, {"folder", "directory"});
  }
  for (const Attempt& attempt : writers("", 73)) {
    if (attempt.command[0] != "dapple") expect_failure(folder, attempt, {"empty"});
  }
}

// What is known beforehand is said before the rendering, which here would take days.
TEST(BadOutput, IsNoticedBeforeTheWork) {
  const TestFolder folder;
  expect_failure(folder, {{"ray", "nowhere/x", "100000", "20000", "10000"}, 1}, {"nowhere/x"});
  expect_failure(
      folder,
      {{"dapple", "render", "nice", "-o", "nowhere/x", "--width=100000", "--height=20000"}, 73},
      {"nowhere/x"});
}

TEST(BadOutput, AFullDevice) {
  const TestFolder folder;
  for (const Attempt& attempt : writers("/dev/full", 74)) {
    expect_failure(folder, attempt, {"/dev/full", "No space left"});
  }
}

// A limit on the size of files stands for a disk that fills up half-way.
TEST(BadOutput, AnEarlierFileIsUntouchedAndNothingIsLeftBehind) {
  const TestFolder folder;
  folder.write("out", "precious");
  RunOptions options;
  options.max_file_size = 100;
  for (const Attempt& attempt : writers("out", 74)) {
    expect_failure(folder, attempt, {"out", "File too large"}, options);
    EXPECT_EQ(folder.read("out"), "precious");
  }
}

TEST(BadOutput, AnEarlierFileIsReplacedAsAWhole) {
  const TestFolder folder;
  folder.write("out", std::string(100'000, 'x'));
  ASSERT_EQ(folder.run({"ray", "out", "2", "1", "1"}).exit_code, 0);
  EXPECT_EQ(folder.read("out").size(), std::string("P6\n2 1\n255\n").size() + 6);
  EXPECT_EQ(folder.names(), (Words{"out"}));
}

TEST(StandardOutput, FailingIsAFailure) {
  const TestFolder folder;
  ASSERT_EQ(folder.run({"store_scene", "good", "nice"}).exit_code, 0);
  const std::vector<Attempt> printers = {
      {{"describe_scene", "good"}, 1}, {{"describe_scene", "--json", "good"}, 1},
      {{"ray", "--help"}, 1},          {{"dapple", "info", "good"}, 74},
      {{"dapple", "scenes"}, 74},      {{"dapple", "--help"}, 74},
      {{"dapple", "--version"}, 74},   {{"dapple", "bench", "good", "--width=8", "--height=8"}, 74},
  };
  for (const Attempt& attempt : printers) {
    RunOptions full, closed;
    full.out_path = "/dev/full";
    closed.close_out = true;
    expect_failure(folder, attempt, {"standard output", "No space left"}, full);
    expect_failure(folder, attempt, {"standard output", "Bad file descriptor"}, closed);
  }
}

// The picture is what the time was spent on: it is written all the same, and whole.
TEST(StandardOutput, FailingDoesNotLoseThePicture) {
  const TestFolder folder;
  folder.run({"ray", "good", "8", "6", "2"});
  for (const std::string program : {"ray", "ray_bvh"}) {
    RunOptions full, closed;
    full.out_path = "/dev/full";
    closed.close_out = true;
    for (const RunOptions& options : {full, closed}) {
      const auto result = folder.run({program, "picture", "8", "6", "2"}, options);
      EXPECT_EQ(result.exit_code, 1);
      EXPECT_TRUE(contains(result.err, "standard output")) << result.err;
      EXPECT_EQ(folder.read("picture"), folder.read("good"));
      std::filesystem::remove(folder.path("picture"));
    }
  }
}

#ifndef DAPPLE_SANITIZED  // sanitizers need more address space than any limit that would show this
TEST(OutOfMemory, IsOneLine) {
  const TestFolder folder;
  RunOptions options;
  options.max_memory = std::size_t{1} << 30;
  expect_failure(folder, {{"ray_bvh", "x", "8", "6", "1", "spheres:100000000"}, 1},
                 {"out of memory"}, options);
  expect_failure(folder, {{"dapple", "render", "spheres:100000000", "-o", "x"}, 71},
                 {"out of memory"}, options);
  expect_failure(folder, {{"dapple", "convert", "spheres:100000000", "-o", "x"}, 71},
                 {"out of memory"}, options);
}
#endif

}  // namespace
}  // namespace dapple
