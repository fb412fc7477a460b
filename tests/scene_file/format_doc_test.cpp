// docs/scene-format.md lists the bytes of `nice`: they must be those that the writer writes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

#include "scene/layered_fields.h"
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

// Where a field of a layered material lies, read from the struct itself.
template <class Member>
std::size_t offset_of(Member LayeredMaterial::*member) {
  static const LayeredMaterial material;
  return static_cast<std::size_t>(reinterpret_cast<const char*>(&(material.*member)) -
                                  reinterpret_cast<const char*>(&material));
}

TEST(FormatDocument, PlacesEveryFieldOfALayeredMaterial) {
  const auto lines = lines_of_document();
  const auto expect_row = [&](std::size_t offset, std::string_view type, std::string_view name) {
    const std::string row = fmt::format("| {} | {} | {} |", offset, type, name);
    EXPECT_TRUE(std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
      return line.starts_with(row);
    })) << row;
  };
  for (const LayeredNumber& n : layered_numbers()) expect_row(offset_of(n.member), "f32", n.name);
  for (const LayeredColour& c : layered_colours()) {
    expect_row(offset_of(c.member), "f32[3]", c.name);
  }
  expect_row(offset_of(&LayeredMaterial::model), "u32", "model");
  expect_row(offset_of(&LayeredMaterial::alpha_mode), "u32", "alpha_mode");
  expect_row(offset_of(&LayeredMaterial::unlit), "u32", "unlit");
  expect_row(offset_of(&LayeredMaterial::double_sided), "u32", "double_sided");
  expect_row(offset_of(&LayeredMaterial::maps), "slot[18]", "maps");
}

TEST(FormatDocument, HasTheVersionInItsHistory) {
  const auto row = fmt::format("| {}.{} |", kFormatMajor, kFormatMinor);
  const auto lines = lines_of_document();
  EXPECT_TRUE(std::any_of(lines.begin(), lines.end(),
                          [&](const std::string& line) { return line.starts_with(row); }));
}

}  // namespace
}  // namespace dapple
