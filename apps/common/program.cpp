#include "common/program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <stdexcept>

#include "util/atomic_file.h"
#include "util/mapped_ranges.h"

namespace dapple {

Expected<int> call_guarded(const std::function<Expected<int>()>& body) try {
  return body();
} catch (const std::bad_alloc&) {
  return fail(Errc::memory, "", "out of memory");
} catch (const std::length_error&) {  // an array larger than any memory
  return fail(Errc::memory, "", "out of memory");
} catch (const std::exception& exception) {
  return fail(Errc::internal, "internal error", exception.what());
}

void prepare_process(int truncation_exit_code) {
  for (int number = 0; number <= STDERR_FILENO; ++number) {
    // The lowest free number is this one: those below are open by now.
    if (::fcntl(number, F_GETFD) < 0) {
      [[maybe_unused]] const int opened =
          ::open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
  }
  std::signal(SIGXFSZ, SIG_IGN);
  exit_when_mapped_file_shrinks(truncation_exit_code);
}

void survive_closed_pipes() { std::signal(SIGPIPE, SIG_IGN); }

void print_message(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stderr); }

void report(std::string_view program, const Error& error) {
  print_message(fmt::format("{}: {}\n", program, to_string(error)));
}

Status check_output(const std::string& path) {
  struct stat status {};
  const bool special =
      ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
  if (!special) {
    const auto file = AtomicFile::create(path);
    return file ? Status{} : tl::unexpected(file.error());
  }
  if (::access(path.c_str(), W_OK) == 0) return {};
  return fail(Errc::cannot_create, path, "cannot create: " + errno_text(errno));
}

}  // namespace dapple
