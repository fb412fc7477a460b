#include "util/mapped_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/util/temporary_folder.h"

namespace dapple {
namespace {

std::string text_of(const MappedFile& file) {
  return {reinterpret_cast<const char*>(file.bytes().data()), file.bytes().size()};
}

TEST(MappedFile, HoldsTheBytesOfTheFile) {
  const TemporaryFolder folder;
  const std::string content = std::string(10'000, 'a') + '\0' + "end";
  put_file(folder / "file", content);
  const auto file = MappedFile::open(folder / "file");
  ASSERT_TRUE(file);
  EXPECT_EQ(text_of(*file), content);
}

TEST(MappedFile, AnEmptyFileHasNoBytes) {
  const TemporaryFolder folder;
  put_file(folder / "empty", "");
  for (const auto& open : {MappedFile::open, MappedFile::open_copy}) {
    const auto file = open(folder / "empty");
    ASSERT_TRUE(file);
    EXPECT_TRUE(file->bytes().empty());
  }
}

TEST(MappedFile, ACopyStaysWhatItWas) {
  const TemporaryFolder folder;
  const std::string content(3'000'000, 'a');
  put_file(folder / "file", content);
  const auto copy = MappedFile::open_copy(folder / "file");
  ASSERT_TRUE(copy);
  put_file(folder / "file", "other content");
  EXPECT_EQ(text_of(*copy), content);
  std::filesystem::resize_file(folder / "file", 0);
  EXPECT_EQ(text_of(*copy), content);
}

TEST(MappedFile, SurvivesMovesAndTheRemovalOfItsName) {
  const TemporaryFolder folder;
  put_file(folder / "a", "content of a");
  put_file(folder / "b", "content of b");
  auto a = MappedFile::open(folder / "a");
  auto b = MappedFile::open(folder / "b");
  ASSERT_TRUE(a && b);
  std::filesystem::remove(folder / "a");
  MappedFile moved = std::move(*a);
  EXPECT_EQ(text_of(moved), "content of a");
  moved = std::move(*b);
  EXPECT_EQ(text_of(moved), "content of b");
}

TEST(MappedFile, WhatIsNoRegularFileIsRefused) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  for (const std::string& path : {folder / "missing", folder / "pipe", folder.path(),
                                  std::string("/dev/zero"), std::string()}) {
    for (const auto& open : {MappedFile::open, MappedFile::open_copy}) {
      const auto file = open(path);
      ASSERT_FALSE(file) << path;
      EXPECT_EQ(file.error().code, Errc::no_input) << path;
      EXPECT_EQ(file.error().place, path);
    }
  }
}

}  // namespace
}  // namespace dapple
