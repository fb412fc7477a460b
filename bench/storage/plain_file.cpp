#include "storage/plain_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <vector>

namespace dapple::bench {
namespace {

constexpr std::size_t kBlock = 4u << 20;

const std::vector<char>& block_of_bytes() {
  static const std::vector<char> block(kBlock, 'd');
  return block;
}

// Closes at the end of its scope.
struct Descriptor {
  int number;
  ~Descriptor() {
    if (number >= 0) close(number);
  }
};

tl::unexpected<Error> io_error(const std::string& path) {
  return fail(Errc::io, path, errno_text(errno));
}

}  // namespace

void copy_in_memory(std::size_t bytes) {
  constexpr std::size_t kSpan = 256u << 20;
  static const std::vector<char> from(kSpan, 'd');
  static std::vector<char> to(kSpan);
  for (std::size_t done = 0; done < bytes; done += kSpan) {
    std::memcpy(to.data(), from.data(), std::min(kSpan, bytes - done));
  }
}

Status write_plain(const std::string& path, std::size_t bytes, Flush flush) {
  const Descriptor file{open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600)};
  if (file.number < 0) return io_error(path);
  for (std::size_t done = 0; done < bytes;) {
    const ssize_t written =
        write(file.number, block_of_bytes().data(), std::min(kBlock, bytes - done));
    if (written <= 0) return io_error(path);
    done += static_cast<std::size_t>(written);
  }
  if (flush == Flush::yes && fsync(file.number) != 0) return io_error(path);
  return unlink(path.c_str()) == 0 ? Status{} : Status(io_error(path));
}

Status read_plain(const std::string& path) {
  static std::vector<char> buffer(kBlock);
  const Descriptor file{open(path.c_str(), O_RDONLY | O_CLOEXEC)};
  if (file.number < 0) return io_error(path);
  for (;;) {
    const ssize_t got = ::read(file.number, buffer.data(), buffer.size());
    if (got < 0) return io_error(path);
    if (got == 0) return {};
  }
}

}  // namespace dapple::bench
