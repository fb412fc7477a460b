#include "util/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <utility>

namespace dapple {
namespace {

constexpr mode_t kNewFileMode = 0666;  // less the umask
constexpr mode_t kPermissions = 0777;
constexpr int kNameTries = 100;
constexpr int kMaxLinks = 40;
constexpr std::size_t kMaxStem = 200;  // leaves room for the rest within the usual 255 bytes

tl::unexpected<Error> creation_failed(const std::string& path, int error_number) {
  return fail(Errc::cannot_create, path, "cannot create: " + errno_text(error_number));
}

tl::unexpected<Error> writing_failed(const std::string& path, int error_number) {
  return fail(Errc::io, path, "cannot write: " + errno_text(error_number));
}

std::string folder_of(const std::string& path) {
  const std::string parent = std::filesystem::path(path).parent_path().string();
  return parent.empty() ? "." : parent;
}

// The file a symbolic link points at is what gets replaced, not the link; it need not exist yet.
Expected<std::string> resolve_links(const std::string& given) {
  std::filesystem::path path = given;
  std::error_code error;
  for (int i = 0; i < kMaxLinks; ++i) {
    if (!std::filesystem::is_symlink(path, error)) return path.string();
    const auto target = std::filesystem::read_symlink(path, error);
    if (error) return creation_failed(given, error.value());
    path = path.parent_path() / target;  // just the target if that is absolute
  }
  return creation_failed(given, ELOOP);
}

// Beside the target, so that renaming never crosses a file system.
std::string temporary_name(const std::string& path, int number) {
  const std::string name = std::filesystem::path(path).filename().string();
  return fmt::format("{}/{}.{}.{}.tmp", folder_of(path), name.substr(0, kMaxStem), ::getpid(),
                     number);
}

std::string descriptor_path(int descriptor) { return fmt::format("/proc/self/fd/{}", descriptor); }

// A file in the target's folder that has no name yet, and so is gone with the process however that
// ends. -1 where the file system has no such files or they cannot be given a name later.
int open_nameless(const std::string& path) {
  const int descriptor =
      ::open(folder_of(path).c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, kNewFileMode);
  if (descriptor >= 0 && ::access(descriptor_path(descriptor).c_str(), F_OK) != 0) {
    ::close(descriptor);
    return -1;
  }
  return descriptor;
}

// Opens, or makes out of `nameless`, a file that did not exist: its name, and its descriptor if it
// was opened.
struct Named {
  std::string name;
  int descriptor = -1;
};
Expected<Named> make_temporary(const std::string& path, int nameless) {
  for (int i = 0; i < kNameTries; ++i) {
    Named file{temporary_name(path, i), -1};
    if (nameless < 0) {
      const int flags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
      file.descriptor = ::open(file.name.c_str(), flags, kNewFileMode);
      if (file.descriptor >= 0) return file;
    } else if (::linkat(AT_FDCWD, descriptor_path(nameless).c_str(), AT_FDCWD, file.name.c_str(),
                        AT_SYMLINK_FOLLOW) == 0) {
      return file;
    }
    if (errno != EEXIST) return creation_failed(path, errno);
  }
  return creation_failed(path, EEXIST);
}

Status sync_folder(const std::string& path) {
  const int folder = ::open(folder_of(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return {};  // a folder one may write but not read: the rename stands anyway
  const int result = ::fsync(folder);
  const int error_number = errno;
  ::close(folder);
  // Some file systems refuse to sync a folder (EINVAL); that is no failure of ours.
  if (result != 0 && error_number != EINVAL) return writing_failed(path, error_number);
  return {};
}

}  // namespace

AtomicFile::AtomicFile(std::string path, int descriptor, bool in_place)
    : path_(std::move(path)), descriptor_(descriptor), in_place_(in_place) {}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)),
      temporary_(std::exchange(other.temporary_, {})),
      descriptor_(std::exchange(other.descriptor_, -1)),
      in_place_(other.in_place_) {}

AtomicFile::~AtomicFile() { discard(); }

Expected<AtomicFile> AtomicFile::create(const std::string& path) {
  if (path.empty()) return fail(Errc::cannot_create, "", "the output file's name is empty");
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return create_temporary(path, std::nullopt);
  // Renaming needs no permission to write the file it replaces, so ask for it by opening.
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) return creation_failed(path, errno);
  if (!S_ISREG(status.st_mode)) return AtomicFile(path, descriptor, true);
  ::close(descriptor);
  return create_temporary(path, status.st_mode & kPermissions);
}

Expected<AtomicFile> AtomicFile::create_temporary(const std::string& given_path,
                                                  std::optional<mode_t> permissions) {
  const auto path = resolve_links(given_path);
  if (!path) return tl::unexpected(path.error());
  AtomicFile file(*path, open_nameless(*path), false);
  if (file.descriptor_ < 0) {
    auto named = make_temporary(*path, -1);
    if (!named) return tl::unexpected(named.error());
    file.temporary_ = std::move(named->name);
    file.descriptor_ = named->descriptor;
  }
  if (permissions && ::fchmod(file.descriptor_, *permissions) != 0) {
    return creation_failed(*path, errno);
  }
  return file;
}

Status AtomicFile::write(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return writing_failed(path_, written < 0 ? errno : EIO);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return {};
}

Status AtomicFile::commit() {
  if (!in_place_) {
    if (::fsync(descriptor_) != 0) return writing_failed(path_, errno);
    if (temporary_.empty()) {
      auto named = make_temporary(path_, descriptor_);
      if (!named) return tl::unexpected(named.error());
      temporary_ = std::move(named->name);
    }
  }
  if (::close(std::exchange(descriptor_, -1)) != 0) return writing_failed(path_, errno);
  if (in_place_) return {};
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) return creation_failed(path_, errno);
  temporary_.clear();
  return sync_folder(path_);
}

void AtomicFile::discard() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

Status write_file_atomically(const std::string& path, std::span<const std::byte> bytes) {
  auto file = AtomicFile::create(path);
  if (!file) return tl::unexpected(file.error());
  if (auto written = file->write(bytes); !written) return written;
  return file->commit();
}

}  // namespace dapple
