// AtomicFile where the system refuses: no space, no permission. Each limit holds in a child process
// only, which answers with its exit status.
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <csignal>
#include <cstdio>
#include <vector>

#include "tests/util/temporary_folder.h"
#include "util/atomic_file.h"

namespace dapple {
namespace {

using Names = std::set<std::string>;

constexpr uid_t kNobody = 65534;
constexpr int kNotAllowed = 200;  // the system did not let the test set its limit

// The error code of write_file_atomically, 0 for success, in a child where `limit` returned true.
template <class Limit>
int code_under(Limit limit, const std::string& path, std::size_t size) {
  const pid_t child = ::fork();
  if (child == 0) {
    if (!limit()) ::_exit(kNotAllowed);
    const Status status = write_file_atomically(path, std::vector<std::byte>(size));
    ::_exit(status ? 0 : static_cast<int>(status.error().code));
  }
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status));
  return WEXITSTATUS(status);
}

bool limit_file_size(rlim_t bytes) {
  const rlimit limit{bytes, bytes};
  return std::signal(SIGXFSZ, SIG_IGN) != SIG_ERR && ::setrlimit(RLIMIT_FSIZE, &limit) == 0;
}

bool become_nobody() {
  return ::geteuid() != 0 || (::setgid(kNobody) == 0 && ::setuid(kNobody) == 0);
}

TEST(AtomicFileLimits, AWriteThatFailsHalfWayLeavesTheOldFileAndNothingElse) {
  const TemporaryFolder folder;
  put_file(folder / "old", "old content");
  const auto limit = [] { return limit_file_size(1000); };
  EXPECT_EQ(code_under(limit, folder / "old", 1000), 0);
  put_file(folder / "old", "old content");
  EXPECT_EQ(code_under(limit, folder / "old", 1001), static_cast<int>(Errc::io));
  EXPECT_EQ(code_under(limit, folder / "new", 100'000), static_cast<int>(Errc::io));
  EXPECT_EQ(get_file(folder / "old"), "old content");
  EXPECT_EQ(folder.names(), Names{"old"});
}

// Root may mount; everyone is root in a user namespace of their own.
bool become_able_to_mount() {
  const uid_t user = ::geteuid();
  const gid_t group = ::getegid();
  if (user == 0) return ::unshare(CLONE_NEWNS) == 0;
  if (::unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return false;
  put_file("/proc/self/setgroups", "deny");
  put_file("/proc/self/uid_map", "0 " + std::to_string(user) + " 1");
  put_file("/proc/self/gid_map", "0 " + std::to_string(group) + " 1");
  return true;
}

// Mounts 64 KiB on `folder`, seen by this process alone and gone with it.
bool mount_tiny(const std::string& folder) {
  return become_able_to_mount() &&
         ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
         ::mount("tmpfs", folder.c_str(), "tmpfs", 0, "size=64k") == 0;
}

// What went wrong on a full file system; empty if nothing did.
std::string fill_file_system(const TemporaryFolder& folder) {
  put_file(folder / "old", "old content");
  const std::vector<std::byte> large(1 << 20);
  for (const char* name : {"old", "new"}) {
    const Status status = write_file_atomically(folder / name, large);
    if (status || status.error().code != Errc::io) return "writing did not fail as it should";
  }
  if (get_file(folder / "old") != "old content") return "the old file changed";
  if (folder.names() != Names{"old"}) return "a temporary remained";
  if (!write_file_atomically(folder / "new", std::span(large).first(1000))) return "no room left";
  return "";
}

TEST(AtomicFileLimits, AFullFileSystemLeavesTheOldFileAndNothingElse) {
  const TemporaryFolder folder;
  const pid_t child = ::fork();
  if (child == 0) {
    if (!mount_tiny(folder.path())) {
      // EINVAL: the root folder is no mount point, as where packages are built under chroot.
      const bool refused = errno == EPERM || errno == EACCES || errno == EINVAL;
      ::_exit(refused ? kNotAllowed : 1);
    }
    const std::string problem = fill_file_system(folder);
    std::fputs(problem.c_str(), stderr);
    ::_exit(problem.empty() ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  // Where nobody may mount, the limit of the file size above has to do.
  EXPECT_TRUE(WEXITSTATUS(status) == 0 || WEXITSTATUS(status) == kNotAllowed);
  RecordProperty("mounted", WEXITSTATUS(status) == 0 ? "yes" : "no");
}

TEST(AtomicFileLimits, AFileThatMayNotBeWrittenIsNotReplaced) {
  const TemporaryFolder folder;
  ASSERT_EQ(::chmod(folder.path().c_str(), 0777), 0);
  put_file(folder / "old", "old content");
  ASSERT_EQ(::chmod((folder / "old").c_str(), 0444), 0);
  EXPECT_EQ(code_under(become_nobody, folder / "old", 10), static_cast<int>(Errc::cannot_create));
  EXPECT_EQ(get_file(folder / "old"), "old content");
  EXPECT_EQ(folder.names(), Names{"old"});
  EXPECT_EQ(code_under(become_nobody, folder / "new", 10), 0);
}

TEST(AtomicFileLimits, AFolderThatMayNotBeWrittenGetsNoFile) {
  const TemporaryFolder folder;
  ASSERT_EQ(::chmod(folder.path().c_str(), 0555), 0);
  EXPECT_EQ(code_under(become_nobody, folder / "new", 10), static_cast<int>(Errc::cannot_create));
  EXPECT_EQ(folder.names(), Names{});
  ASSERT_EQ(::chmod(folder.path().c_str(), 0755), 0);
}

}  // namespace
}  // namespace dapple
