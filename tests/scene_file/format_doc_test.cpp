// docs/scene-format.md lists the bytes of `nice`: they must be those that the writer writes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

#include "scene/named_scenes.h"
#include "scene_file/format.h"
#include "scene_file/section_table.h"
#include "tests/scene_file/scene_bytes.h"

namespace dapple {
namespace {

std::vector<std::string> lines_of_document() {
  std::ifstream file(DAPPLE_SOURCE_DIR "/docs/scene-format.md");
  EXPECT_TRUE(file.is_open());
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

TEST(FormatDocument, ListsEveryByteOfNice) {
  const auto file = test::scene_bytes(*make_named_scene("nice"));
  const std::regex listing("^([0-9a-f]{6})  ((?:[0-9a-f]{2} )*[0-9a-f]{2})  .*");
  std::size_t next = 0;
  for (const std::string& line : lines_of_document()) {
    std::smatch match;
    if (!std::regex_match(line, match, listing)) continue;
    ASSERT_EQ(std::stoul(match[1], nullptr, 16), next) << line;
    std::istringstream bytes(match[2]);
    for (std::string byte; bytes >> byte; ++next) {
      ASSERT_LT(next, file.size()) << line;
      ASSERT_EQ(std::stoul(byte, nullptr, 16), std::to_integer<unsigned>(file[next])) << line;
    }
  }
  EXPECT_EQ(next, file.size());
}

TEST(FormatDocument, NamesEverySectionWithItsStride) {
  const auto lines = lines_of_document();
  for (const SectionKind& kind : section_kinds()) {
    const std::string name =
        fmt::format("`{}`", section_name(static_cast<std::uint32_t>(kind.type)));
    const std::string stride = fmt::format("| {} |", kind.stride);
    const char* critical = kind.flags == kSectionCritical ? "| yes |" : "| no |";
    const bool found = std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
      return line.find(name) != line.npos && line.find(stride) != line.npos &&
             line.find(critical) != line.npos;
    });
    EXPECT_TRUE(found) << name << " " << stride << " " << critical;
  }
}

TEST(FormatDocument, HasTheVersionInItsHistory) {
  const auto row = fmt::format("| {}.{} |", kFormatMajor, kFormatMinor);
  const auto lines = lines_of_document();
  EXPECT_TRUE(std::any_of(lines.begin(), lines.end(),
                          [&](const std::string& line) { return line.starts_with(row); }));
}

}  // namespace
}  // namespace dapple
