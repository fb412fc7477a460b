#include "util/atomic_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "tests/util/temporary_folder.h"

namespace dapple {
namespace {

using Names = std::set<std::string>;

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text));
}

mode_t mode_of(const std::string& path) {
  struct stat status {};
  EXPECT_EQ(::stat(path.c_str(), &status), 0) << path;
  return status.st_mode & 07777;
}

// A umask for the length of a scope.
class Umask {
 public:
  explicit Umask(mode_t mask) : before_(::umask(mask)) {}
  ~Umask() { ::umask(before_); }

 private:
  mode_t before_;
};

Errc code_of(const Status& status) { return status ? Errc{} : status.error().code; }

TEST(AtomicFile, CommittedFileHasAllBytesAndNothingElseRemains) {
  const TemporaryFolder folder;
  auto file = AtomicFile::create(folder / "new");
  ASSERT_TRUE(file);
  ASSERT_TRUE(file->write(bytes_of("one")));
  ASSERT_TRUE(file->write({}));
  ASSERT_TRUE(file->write(bytes_of(" two")));
  EXPECT_EQ(folder.names().count("new"), 0u) << "visible before commit()";
  ASSERT_TRUE(file->commit());
  EXPECT_EQ(get_file(folder / "new"), "one two");
  EXPECT_EQ(folder.names(), Names{"new"});
}

TEST(AtomicFile, AnEmptyFileCanBeWritten) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_file_atomically(folder / "empty", {}));
  EXPECT_EQ(folder.names(), Names{"empty"});
  EXPECT_EQ(get_file(folder / "empty"), "");
}

TEST(AtomicFile, WithoutCommitTheOldFileStaysAndNothingElseRemains) {
  const TemporaryFolder folder;
  put_file(folder / "old", "old content");
  {
    auto file = AtomicFile::create(folder / "old");
    ASSERT_TRUE(file && file->write(bytes_of("new")));
    EXPECT_EQ(get_file(folder / "old"), "old content");
    EXPECT_LE(folder.names().size(), 2u);  // the temporary may have a name
  }
  EXPECT_EQ(get_file(folder / "old"), "old content");
  EXPECT_EQ(folder.names(), Names{"old"});
}

TEST(AtomicFile, AProcessThatIsKilledLeavesNothing) {
  const TemporaryFolder folder;
  const int probe = ::open((folder / ".").c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0600);
  const bool has_nameless_files = probe >= 0;
  if (has_nameless_files) ::close(probe);
  put_file(folder / "old", "old content");
  const pid_t child = ::fork();
  if (child == 0) {
    auto file = AtomicFile::create(folder / "old");
    if (file && file->write(bytes_of("half of it"))) ::kill(::getpid(), SIGKILL);
    ::_exit(1);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(get_file(folder / "old"), "old content");
  if (has_nameless_files) {
    EXPECT_EQ(folder.names(), Names{"old"});
  }
}

TEST(AtomicFile, MovingHandsOverTheTemporary) {
  const TemporaryFolder folder;
  {
    auto file = AtomicFile::create(folder / "moved");
    ASSERT_TRUE(file && file->write(bytes_of("a")));
    AtomicFile other = std::move(*file);
    ASSERT_TRUE(other.write(bytes_of("b")));
    ASSERT_TRUE(other.commit());
  }
  EXPECT_EQ(get_file(folder / "moved"), "ab");
  EXPECT_EQ(folder.names(), Names{"moved"});
}

TEST(AtomicFile, TwoWritersOfOneTargetDoNotMix) {
  const TemporaryFolder folder;
  auto first = AtomicFile::create(folder / "both");
  auto second = AtomicFile::create(folder / "both");
  ASSERT_TRUE(first && second);
  ASSERT_TRUE(first->write(bytes_of("first")));
  ASSERT_TRUE(second->write(bytes_of("2nd")));
  ASSERT_TRUE(second->commit());
  EXPECT_EQ(get_file(folder / "both"), "2nd");
  ASSERT_TRUE(first->commit());
  EXPECT_EQ(get_file(folder / "both"), "first");
  EXPECT_EQ(folder.names(), Names{"both"});
}

TEST(AtomicFile, NewFilesHonourTheUmask) {
  const TemporaryFolder folder;
  for (const mode_t mask : {0022, 0027, 0077}) {
    const Umask scope(mask);
    const std::string path = folder / std::to_string(mask);
    ASSERT_TRUE(write_file_atomically(path, bytes_of("x")));
    EXPECT_EQ(mode_of(path), 0666 & ~mask);
  }
}

TEST(AtomicFile, ReplacedFilesKeepTheirPermissions) {
  const TemporaryFolder folder;
  const Umask scope(0022);
  for (const mode_t mode : {0600, 0640, 0666, 0755}) {
    const std::string path = folder / "file";
    put_file(path, "old");
    ASSERT_EQ(::chmod(path.c_str(), mode), 0);
    ASSERT_TRUE(write_file_atomically(path, bytes_of("new")));
    EXPECT_EQ(get_file(path), "new");
    EXPECT_EQ(mode_of(path), mode);
  }
}

TEST(AtomicFile, ASymbolicLinkStaysAndItsTargetIsReplaced) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "sub");
  put_file(folder / "sub/target", "old");
  std::filesystem::create_symlink("sub/target", folder / "link");
  std::filesystem::create_symlink(folder / "link", folder / "chain");
  ASSERT_TRUE(write_file_atomically(folder / "chain", bytes_of("new")));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "chain"));
  EXPECT_FALSE(std::filesystem::is_symlink(folder / "sub/target"));
  EXPECT_EQ(get_file(folder / "sub/target"), "new");
  EXPECT_EQ(folder.names(), (Names{"chain", "link", "sub"}));
}

TEST(AtomicFile, ADanglingLinkGetsItsTarget) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("target", folder / "link");
  ASSERT_TRUE(write_file_atomically(folder / "link", bytes_of("new")));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(get_file(folder / "target"), "new");
}

TEST(AtomicFile, LinksInACircleAreAnError) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("b", folder / "a");
  std::filesystem::create_symlink("a", folder / "b");
  EXPECT_EQ(code_of(write_file_atomically(folder / "a", {})), Errc::cannot_create);
  EXPECT_EQ(folder.names(), (Names{"a", "b"}));
}

TEST(AtomicFile, NamesOfFullLengthWorkAndLongerOnesAreAnError) {
  const TemporaryFolder folder;
  const std::string longest(255, 'n');
  ASSERT_TRUE(write_file_atomically(folder / longest, bytes_of("x")));
  EXPECT_EQ(folder.names(), Names{longest});
  EXPECT_EQ(code_of(write_file_atomically(folder / (longest + "n"), {})), Errc::cannot_create);
  EXPECT_EQ(folder.names(), Names{longest});
}

TEST(AtomicFile, ImpossibleTargetsCannotBeCreated) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "folder");
  put_file(folder / "file", "content");
  for (const std::string& path :
       {std::string(), folder / "missing/file", folder / "missing/", folder / "folder",
        folder / "folder/", folder / "file/inside", folder / "file/", std::string("/dev/null/x")}) {
    const Status status = write_file_atomically(path, bytes_of("x"));
    EXPECT_EQ(code_of(status), Errc::cannot_create) << path;
    EXPECT_NE(to_string(status.error()).find(path), std::string::npos);
  }
  EXPECT_EQ(folder.names(), (Names{"file", "folder"}));
  EXPECT_EQ(get_file(folder / "file"), "content");
}

TEST(AtomicFile, PipesAreWrittenInPlaceUnderTheirDescriptorsName) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  EXPECT_TRUE(write_file_atomically("/dev/fd/" + std::to_string(ends[1]), bytes_of("through")));
  char text[16] = {};
  EXPECT_EQ(::read(ends[0], text, sizeof text), 7);
  EXPECT_STREQ(text, "through");
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST(AtomicFile, DevicesAreWrittenInPlace) {
  EXPECT_TRUE(write_file_atomically("/dev/null", bytes_of("x")));
  const Status full = write_file_atomically("/dev/full", bytes_of("x"));
  EXPECT_EQ(code_of(full), Errc::io);
  EXPECT_NE(to_string(full.error()).find("/dev/full"), std::string::npos);
}

}  // namespace
}  // namespace dapple
