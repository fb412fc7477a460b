// `dapple scaling` from outside.
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/apps/run_program.h"

namespace dapple {
namespace {

using Words = std::vector<std::string>;

// Small enough to be over at once; noisy, of course.
Words tiny(const Words& more) {
  Words words = {"dapple",      "scaling",        "--width=32", "--height=32", "--spp=1",
                 "--bvh-spp=1", "--objects=2000", "--repeat=2", "--patience=0"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(ScalingCommand, LeavesTablesPlotsAndWarnings) {
  const TestFolder folder;
  const auto result = folder.run(tiny({"--threads", "3,1", "-o", "out/deep"}));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("ray_bvh, weak scaling: rgbbox, 32 x 32 pixels"), std::string::npos);
  EXPECT_NE(result.err.find("repetitions are too few"), std::string::npos) << result.err;
  EXPECT_TRUE(folder.read("out/deep/points.csv").starts_with("work,mode,threads,"));
  EXPECT_NE(folder.read("out/deep/points.csv").find("\nbuild,weak,3,"), std::string::npos);
  EXPECT_NE(folder.read("out/deep/machine.csv").find("\nwarning,"), std::string::npos);
  EXPECT_TRUE(folder.read("out/deep/strong-speedup.svg").starts_with("<?xml"));
  const auto json = nlohmann::json::parse(folder.read("out/deep/scaling.json"));
  EXPECT_EQ(json["curves"].size(), 6u);
  EXPECT_EQ(json["base"]["scene"], "rgbbox");
  EXPECT_EQ(json["rounds"], 2);
}

TEST(ScalingCommand, MeasuresOnlyWhatIsAskedFor) {
  const TestFolder folder;
  const auto result =
      folder.run(tiny({"nice", "-o", "out", "-w", "ray", "-w", "ray", "--json", "--threads=1"}));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  ASSERT_EQ(json["curves"].size(), 2u);
  EXPECT_EQ(json["curves"][0]["work"], "ray");
  EXPECT_TRUE(json["curves"][0]["serial_fraction"].is_null());
  EXPECT_EQ(json["measurements"].size(), 1u);
}

TEST(ScalingCommand, ReadsSceneFiles) {
  const TestFolder folder;
  ASSERT_EQ(folder.run({"dapple", "convert", "nice", "-o", "my.scene", "-q"}).exit_code, 0);
  const auto result = folder.run(tiny({"my.scene", "-o", "out", "-q", "--work=ray_bvh"}));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "");
}

TEST(ScalingCommand, WrongUsageIsExit64) {
  const TestFolder folder;
  const std::vector<Words> commands = {{"dapple", "scaling"},
                                       tiny({"-o", "x", "--threads", ""}),
                                       tiny({"-o", "x", "--threads=0"}),
                                       tiny({"-o", "x", "--threads=1,,2"}),
                                       tiny({"-o", "x", "--threads=1,2,"}),
                                       tiny({"-o", "x", "--threads=two"}),
                                       tiny({"-o", "x", "--threads=5000"}),
                                       tiny({"-o", "x", "--work=tea"}),
                                       tiny({"-o", "x", "--repeat=0"}),
                                       tiny({"-o", "x", "no-such:scene"})};
  for (const Words& command : commands) {
    const auto result = folder.run(command);
    EXPECT_NE(result.exit_code, 0);
    EXPECT_TRUE(result.exit_code == 64 || command.back() == "no-such:scene")
        << testing::PrintToString(command);
    EXPECT_EQ(result.out, "");
  }
}

TEST(ScalingCommand, ASignalEndsItAndLeavesNoTables) {
  const TestFolder folder;
  RunningProgram running(folder, {"dapple", "scaling", "-o", "out", "--repeat=1000"},
                         RunningProgram::ErrorStream::pipe);
  ASSERT_TRUE(running.wait_until_caught(SIGINT));
  running.send(SIGINT);
  EXPECT_EQ(running.finish().exit_code, 75);
  EXPECT_FALSE(std::filesystem::exists(folder.path("out/points.csv")));
}

TEST(ScalingCommand, ShowsItsProgressOnATerminal) {
  const TestFolder folder;
  RunningProgram running(folder, {"dapple", "scaling", "-o", "out", "--repeat=1000"},
                         RunningProgram::ErrorStream::terminal);
  ASSERT_TRUE(running.read_error_until("0 of "));
  running.send(SIGTERM);
  EXPECT_EQ(running.finish().exit_code, 75);
}

TEST(ScalingCommand, AFolderThatCannotBeIsKnownBeforeTheStudy) {
  const TestFolder folder;
  folder.write("file", "");
  const auto result = folder.run(tiny({"-o", "file/out"}));
  EXPECT_EQ(result.exit_code, 73);
  EXPECT_NE(result.err.find("file/out"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace dapple
