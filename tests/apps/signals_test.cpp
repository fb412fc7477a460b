// A program that is asked to stop, stops: exit code, one line, nothing left behind.
#include <gtest/gtest.h>

#include <csignal>

#include "tests/apps/run_program.h"

namespace dapple {
namespace {

using Words = std::vector<std::string>;

// Hours of work, in units of milliseconds.
Words long_rendering(const std::string& program) {
  if (program == "dapple") {
    return {"dapple", "render",   "nice", "-o",    "out",   "--width",
            "300",    "--height", "300",  "--spp", "100000"};
  }
  return {program, "out", "300", "300", "100000"};
}

void expect_stop(const std::string& program, int signal_number, int exit_code) {
  SCOPED_TRACE(program);
  const TestFolder folder;
  folder.write("out", "precious");
  RunningProgram running(folder, long_rendering(program), RunningProgram::ErrorStream::pipe);
  ASSERT_TRUE(running.wait_until_caught(signal_number));
  running.send(signal_number);
  const auto result = running.finish();
  EXPECT_EQ(result.exit_code, exit_code);
  EXPECT_TRUE(result.err.starts_with(program + ": ")) << result.err;
  EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
  EXPECT_EQ(folder.names(), (Words{"out"}));
  EXPECT_EQ(folder.read("out"), "precious");
}

TEST(StopSignals, DappleEndsWith75) {
  expect_stop("dapple", SIGTERM, 75);
  expect_stop("dapple", SIGINT, 75);
  expect_stop("dapple", SIGHUP, 75);
}

TEST(StopSignals, MeasurementsEndWith75) {
  const TestFolder folder;
  RunningProgram running(folder, {"dapple", "bench", "spheres:1000", "--repeat", "1000"},
                         RunningProgram::ErrorStream::pipe);
  ASSERT_TRUE(running.wait_until_caught(SIGINT));
  running.send(SIGINT);
  const auto result = running.finish();
  EXPECT_EQ(result.exit_code, 75);
  EXPECT_TRUE(result.err.starts_with("dapple: ")) << result.err;
}

TEST(StopSignals, ClassicProgramsFail) {
  expect_stop("ray", SIGTERM, 1);
  expect_stop("ray_bvh", SIGINT, 1);
}

TEST(StopSignals, TheProgressBarIsOnTerminalsOnlyAndGoesAway) {
  const TestFolder folder;
  RunningProgram running(folder, long_rendering("dapple"), RunningProgram::ErrorStream::terminal);
  ASSERT_TRUE(running.read_error_until(" left"));
  running.send(SIGTERM);
  const auto result = running.finish();
  EXPECT_EQ(result.exit_code, 75);
  EXPECT_NE(result.err.find("% ["), std::string::npos) << result.err;
  EXPECT_NE(result.err.find(" samples/s, "), std::string::npos) << result.err;
  // The line is erased before the message comes.
  const std::size_t message = result.err.find("dapple: ");
  ASSERT_NE(message, std::string::npos);
  EXPECT_EQ(result.err.substr(message - 4, 4), "\r\033[K");
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace dapple
