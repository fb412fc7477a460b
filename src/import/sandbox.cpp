#include "import/sandbox.h"

#include <fcntl.h>
#include <linux/openat2.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace dapple {
namespace {

// O_NONBLOCK: opening a pipe that nobody writes must not hang.
constexpr int kFlags = O_RDONLY | O_CLOEXEC | O_NONBLOCK;

int open_beneath(int folder, const char* name) {
  open_how how{};
  how.flags = static_cast<std::uint64_t>(kFlags);
  how.resolve = RESOLVE_BENEATH | RESOLVE_NO_MAGICLINKS;
  return static_cast<int>(::syscall(SYS_openat2, folder, name, &how, sizeof how));
}

// For kernels and containers without openat2: one component after the other, none of them a link.
int open_by_steps(int folder, std::string_view name) {
  if (name.starts_with('/')) return errno = EXDEV, -1;
  int at = ::fcntl(folder, F_DUPFD_CLOEXEC, 0);
  while (at >= 0) {
    const std::size_t slash = name.find('/');
    const std::string step(name.substr(0, slash));
    const bool last = slash == std::string_view::npos;
    int next = -1;
    if (step == "..") {
      errno = EXDEV;
    } else {
      next = ::openat(at, step.empty() ? "." : step.c_str(),
                      kFlags | O_NOFOLLOW | (last ? 0 : O_DIRECTORY));
    }
    const int reason = errno;
    ::close(at);
    errno = reason;
    if (last) return next;
    at = next;
    name.remove_prefix(slash + 1);
  }
  return -1;
}

bool is_unavailable(int error_number) { return error_number == ENOSYS || error_number == EPERM; }

}  // namespace

Expected<Sandbox> Sandbox::around(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "" : path.substr(0, slash + 1);
  const int descriptor =
      ::open(folder.empty() ? "." : folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) {
    return fail(Errc::no_input, path, "cannot open its folder: " + errno_text(errno));
  }
  return Sandbox(descriptor, folder);
}

Sandbox::Sandbox(Sandbox&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), folder_(std::move(other.folder_)) {}

Sandbox& Sandbox::operator=(Sandbox&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(folder_, other.folder_);
  return *this;
}

Sandbox::~Sandbox() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::string Sandbox::path_of(std::string_view name) const { return folder_ + std::string(name); }

Expected<MappedFile> Sandbox::open(const std::string& name) const {
  const std::string path = path_of(name);
  if (name.empty() || name.find('\0') != std::string::npos) {
    return fail(Errc::bad_data, path, "is not the name of a file");
  }
  int file = open_beneath(descriptor_, name.c_str());
  if (file < 0 && is_unavailable(errno)) file = open_by_steps(descriptor_, name);
  if (file < 0 && (errno == EXDEV || errno == ELOOP)) {
    return fail(Errc::bad_data, path, "lies outside the folder of the file that names it");
  }
  if (file < 0) return fail(Errc::no_input, path, "cannot open: " + errno_text(errno));
  auto mapped = MappedFile::map(file, path);
  ::close(file);
  return mapped;
}

}  // namespace dapple
