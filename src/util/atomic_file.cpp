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
constexpr int kNameTries = 100;

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

// The file a symbolic link points at is what gets replaced, not the link.
std::string resolve_links(const std::string& path) {
  std::error_code ignored;
  const auto resolved = std::filesystem::weakly_canonical(path, ignored);
  return ignored || !std::filesystem::is_symlink(path, ignored) ? path : resolved.string();
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

AtomicFile::AtomicFile(std::string path, std::string temporary, int descriptor)
    : path_(std::move(path)), temporary_(std::move(temporary)), descriptor_(descriptor) {}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)),
      temporary_(std::exchange(other.temporary_, {})),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

AtomicFile::~AtomicFile() { discard(); }

Expected<AtomicFile> AtomicFile::create(const std::string& given_path) {
  if (given_path.empty()) return fail(Errc::cannot_create, "", "the output file's name is empty");
  const std::string path = resolve_links(given_path);
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) {
    if (S_ISDIR(status.st_mode)) return creation_failed(path, EISDIR);
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) return creation_failed(path, errno);
    return AtomicFile(path, {}, descriptor);
  }
  for (int i = 0; i < kNameTries; ++i) {
    std::string temporary = fmt::format("{}.{}.{}.tmp", path, ::getpid(), i);
    const int flags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
    const int descriptor = ::open(temporary.c_str(), flags, kNewFileMode);
    if (descriptor >= 0) return AtomicFile(path, std::move(temporary), descriptor);
    if (errno != EEXIST) return creation_failed(path, errno);
  }
  return creation_failed(path, EEXIST);
}

Status AtomicFile::write(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0) {
      if (errno == EINTR) continue;
      return writing_failed(path_, errno);
    }
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return {};
}

Status AtomicFile::commit() {
  const bool in_place = temporary_.empty();
  if (!in_place && ::fsync(descriptor_) != 0) return writing_failed(path_, errno);
  if (::close(std::exchange(descriptor_, -1)) != 0) return writing_failed(path_, errno);
  if (in_place) return {};
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
