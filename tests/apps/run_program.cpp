#include "tests/apps/run_program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace dapple {
namespace {

std::string program_path(const std::string& name) {
  return name.find('/') == std::string::npos ? DAPPLE_PROGRAM_FOLDER "/" + name : name;
}

std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void limit(decltype(RLIMIT_AS) resource, std::size_t bytes) {
  if (bytes == 0) return;
  const rlimit both{bytes, bytes};
  setrlimit(resource, &both);
}

void redirect(int stream, const std::string& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  ::dup2(file, stream);
  ::close(file);
}

// In the child: becomes the program, or ends with 127 as a shell's child would.
[[noreturn]] void become(const std::vector<std::string>& command) {
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  ::execv(program_path(command[0]).c_str(), arguments.data());
  ::_exit(127);
}

int exit_code_of(pid_t process) {
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

TestFolder::TestFolder() {
  std::string name = testing::TempDir() + "dapple_apps_XXXXXX";
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make " + name);
  folder_ = name;
}

TestFolder::~TestFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

ProgramResult TestFolder::run(const std::vector<std::string>& command,
                              const RunOptions& options) const {
  // What it prints stands outside the folder, which tests look into.
  const std::string out = folder_.string() + ".out", err = folder_.string() + ".err";
  const pid_t process = ::fork();
  if (process == 0) {
    if (::chdir(folder_.c_str()) != 0) ::_exit(126);
    redirect(STDOUT_FILENO, options.out_path.empty() ? out : options.out_path);
    redirect(STDERR_FILENO, err);
    if (options.close_out) ::close(STDOUT_FILENO);
    for (const auto& [name, value] : options.environment) ::setenv(name.c_str(), value.c_str(), 1);
    limit(RLIMIT_FSIZE, options.max_file_size);
    limit(RLIMIT_AS, options.max_memory);
    become(command);
  }
  ProgramResult result;
  result.exit_code = exit_code_of(process);
  result.out = read_file(out);
  result.err = read_file(err);
  std::filesystem::remove(out);
  std::filesystem::remove(err);
  return result;
}

std::string TestFolder::read(const std::string& name) const { return read_file(path(name)); }

void TestFolder::write(const std::string& name, const std::string& bytes) const {
  std::ofstream(path(name), std::ios::binary) << bytes;
}

std::vector<std::string> TestFolder::names() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

RunningProgram::RunningProgram(const TestFolder& folder, const std::vector<std::string>& command,
                               ErrorStream stream) {
  int ends[2] = {-1, -1};  // ours, the program's
  if (stream == ErrorStream::terminal) {
    if (::openpty(&ends[0], &ends[1], nullptr, nullptr, nullptr) != 0) {
      throw std::runtime_error("no terminal");
    }
  } else if (::pipe(ends) != 0) {
    throw std::runtime_error("no pipe");
  }
  process_ = ::fork();
  if (process_ == 0) {
    if (::chdir(folder.path("").c_str()) != 0) ::_exit(126);
    redirect(STDOUT_FILENO, "/dev/null");
    ::dup2(ends[1], STDERR_FILENO);
    ::close(ends[0]);
    ::close(ends[1]);
    become(command);
  }
  ::close(ends[1]);
  error_stream_ = ends[0];
}

RunningProgram::~RunningProgram() {
  if (process_ > 0) {
    send(SIGKILL);
    exit_code_of(process_);
  }
  ::close(error_stream_);
}

bool RunningProgram::wait_until_caught(int signal_number) const {
  const std::uint64_t bit = std::uint64_t{1} << (signal_number - 1);
  while (true) {
    const std::string status = read_file("/proc/" + std::to_string(process_) + "/status");
    const std::size_t caught = status.find("SigCgt:");
    if (caught == std::string::npos || status.find("State:\tZ") != std::string::npos) return false;
    if ((std::strtoull(status.c_str() + caught + 7, nullptr, 16) & bit) != 0) return true;
    ::usleep(1000);
  }
}

// False at the end of the stream (a terminal ends with an error).
bool RunningProgram::read_some() {
  char buffer[4096];
  const ssize_t length = ::read(error_stream_, buffer, sizeof(buffer));
  if (length <= 0) return false;
  error_text_.append(buffer, static_cast<std::size_t>(length));
  return true;
}

bool RunningProgram::read_error_until(const std::string& text) {
  while (error_text_.find(text) == std::string::npos) {
    if (!read_some()) return false;
  }
  return true;
}

void RunningProgram::send(int signal_number) const { ::kill(process_, signal_number); }

ProgramResult RunningProgram::finish() {
  while (read_some()) {
  }
  ProgramResult result;
  result.exit_code = exit_code_of(process_);
  process_ = -1;
  result.err = error_text_;
  return result;
}

}  // namespace dapple
