// `dapple compare` from outside.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "image/formats.h"
#include "tests/apps/run_program.h"

namespace dapple {
namespace {

using Words = std::vector<std::string>;
using nlohmann::json;

Words render_words(const std::string& output) {
  return {"dapple", "render", "nice", "-o", output, "--width=24", "--height=18", "--spp=3"};
}

TEST(Compare, ExitCodeSaysWhetherWithinTheThreshold) {
  const TestFolder folder;
  Image a(4, 2), b(4, 2);
  b.pixels[5] = {0.5f, 0, 0};  // column 1, row 1; root mean square 0.5 / sqrt(24)
  ASSERT_TRUE(write_image(folder.path("a.pfm").string(), a, {}));
  ASSERT_TRUE(write_image(folder.path("b.pfm").string(), b, {}));
  const auto exit_code = [&](const Words& more) {
    Words words = {"dapple", "compare", "a.pfm", "b.pfm"};
    words.insert(words.end(), more.begin(), more.end());
    return folder.run(words).exit_code;
  };
  EXPECT_EQ(folder.run({"dapple", "compare", "a.pfm", "a.pfm"}).exit_code, 0);
  EXPECT_EQ(exit_code({}), 1);
  EXPECT_EQ(exit_code({"-q"}), 1);
  EXPECT_EQ(exit_code({"--threshold", "0.1"}), 1);
  EXPECT_EQ(exit_code({"--threshold", "0.11"}), 0);
  const auto result = folder.run({"dapple", "compare", "--json", "a.pfm", "b.pfm"});
  EXPECT_EQ(result.exit_code, 1);
  const json difference = json::parse(result.out);
  EXPECT_NEAR(difference["rmse"].get<double>(), 0.5 / std::sqrt(24.0), 1e-12);
  EXPECT_EQ(difference["maximum"], 0.5);
  EXPECT_EQ(difference["maximum_at"], (json{1, 1}));
  EXPECT_EQ(difference["within_threshold"], false);
}

TEST(Compare, AlphaCounts) {
  const TestFolder folder;
  Image opaque(4, 2), thin(4, 2);
  opaque.alpha.assign(8, 1.0f);
  thin.alpha.assign(8, 0.6f);
  for (const std::string ending : {".exr", ".png"}) {
    const std::string none = "none" + ending, one = "opaque" + ending, less = "thin" + ending;
    ASSERT_TRUE(write_image(folder.path(none).string(), Image(4, 2), {}));
    ASSERT_TRUE(write_image(folder.path(one).string(), opaque, {}));
    ASSERT_TRUE(write_image(folder.path(less).string(), thin, {}));
    const auto exit_code = [&](const std::string& a, const std::string& b, const char* limit) {
      return folder.run({"dapple", "compare", "-q", a, b, "--threshold", limit}).exit_code;
    };
    EXPECT_EQ(exit_code(one, none, "0"), 0);
    EXPECT_EQ(exit_code(one, less, "0.39"), 1);
    EXPECT_EQ(exit_code(none, less, "0.39"), 1);
    EXPECT_EQ(exit_code(less, none, "0.41"), 0);
    const auto result = folder.run({"dapple", "compare", "--json", one, less});
    const json difference = json::parse(result.out);
    EXPECT_EQ(difference["rmse"], 0);
    EXPECT_NEAR(difference["alpha_rmse"].get<double>(), 0.4, 0.001);  // half a step of a half float
    EXPECT_NEAR(difference["alpha_maximum"].get<double>(), 0.4, 0.001);
    EXPECT_EQ(difference["within_threshold"], false);
  }
}

TEST(Compare, ReadsWhatRenderWrites) {
  const TestFolder folder;
  ASSERT_EQ(folder.run(render_words("reference.pfm")).exit_code, 0);
  for (const std::string name : {"a.png", "a.exr", "a.hdr", "a.ppm"}) {
    ASSERT_EQ(folder.run(render_words(name)).exit_code, 0);
    // Half a step of eight bits is at most 0.0045 in linear light, of a shared exponent 0.004.
    const auto result =
        folder.run({"dapple", "compare", "reference.pfm", name, "--threshold", "0.0045"});
    EXPECT_EQ(result.exit_code, 0) << name << '\n' << result.out << result.err;
  }
}

TEST(Compare, WhatCannotBeComparedIsNoDifference) {
  const TestFolder folder;
  ASSERT_TRUE(write_image(folder.path("a.pfm").string(), Image(4, 2), {}));
  ASSERT_TRUE(write_image(folder.path("b.pfm").string(), Image(2, 4), {}));
  folder.write("text", "no image");
  EXPECT_EQ(folder.run({"dapple", "compare", "a.pfm", "b.pfm"}).exit_code, 65);
  EXPECT_EQ(folder.run({"dapple", "compare", "a.pfm", "text"}).exit_code, 65);
  EXPECT_EQ(folder.run({"dapple", "compare", "a.pfm", "missing"}).exit_code, 66);
}

}  // namespace
}  // namespace dapple
