#include "util/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace dapple {
namespace {

tl::unexpected<Error> opening_failed(const std::string& path, int error_number) {
  return fail(Errc::no_input, path, "cannot open: " + errno_text(error_number));
}

// Closes the descriptor at the end of a scope: a mapping outlives it.
struct Descriptor {
  int number = -1;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
};

// O_NONBLOCK: opening a pipe that nobody writes must not hang.
int open_to_read(const std::string& path) {
  return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
}

// Until the end of the file, which may come at any time.
Status copy_bytes(int from, int to, const std::string& path) {
  constexpr std::size_t kAtOnce = std::size_t{1} << 30;
  while (true) {
    const ssize_t copied = ::sendfile(to, from, nullptr, kAtOnce);
    if (copied == 0) return {};
    if (copied < 0 && errno != EINTR) {
      return fail(Errc::io, path, "cannot copy into memory: " + errno_text(errno));
    }
  }
}

}  // namespace

Expected<MappedFile> MappedFile::open(const std::string& path) {
  const Descriptor file{open_to_read(path)};
  if (file.number < 0) return opening_failed(path, errno);
  return map(file.number, path);
}

Expected<MappedFile> MappedFile::open_copy(const std::string& path) {
  const Descriptor file{open_to_read(path)};
  if (file.number < 0) return opening_failed(path, errno);
  struct stat status {};
  if (::fstat(file.number, &status) != 0) return opening_failed(path, errno);
  if (!S_ISREG(status.st_mode)) return map(file.number, path);  // which says what it is instead
  const Descriptor copy{::memfd_create("dapple", MFD_CLOEXEC | MFD_ALLOW_SEALING)};
  if (copy.number < 0) return opening_failed(path, errno);
  if (auto copied = copy_bytes(file.number, copy.number, path); !copied) {
    return tl::unexpected(copied.error());
  }
  const int seals = F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_WRITE | F_SEAL_SEAL;
  if (::fcntl(copy.number, F_ADD_SEALS, seals) != 0) return opening_failed(path, errno);
  return map(copy.number, path);
}

Expected<MappedFile> MappedFile::map(int descriptor, const std::string& path) {
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) return opening_failed(path, errno);
  if (S_ISDIR(status.st_mode)) return opening_failed(path, EISDIR);
  if (!S_ISREG(status.st_mode)) return fail(Errc::no_input, path, "not a regular file");
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size == 0) return MappedFile();
  // Not shared: a file sealed against writing may not be mapped so by older systems.
  void* address = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor, 0);
  if (address == MAP_FAILED) return opening_failed(path, errno);
  return MappedFile({static_cast<const std::byte*>(address), size}, path);
}

MappedFile::MappedFile(MappedFile&& other) noexcept
    : bytes_(std::exchange(other.bytes_, std::span<const std::byte>{})),
      range_(std::move(other.range_)) {}

MappedFile& MappedFile::operator=(MappedFile&& other) noexcept {
  std::swap(bytes_, other.bytes_);
  std::swap(range_, other.range_);
  return *this;
}

MappedFile::~MappedFile() {
  if (!bytes_.empty()) ::munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
}

}  // namespace dapple
