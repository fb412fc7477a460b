// Runs the built programs as a shell would.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace dapple {

struct ProgramResult {
  int exit_code = -1;  // 128 + the signal's number if one ended it
  std::string out;
  std::string err;
};

struct RunOptions {
  std::map<std::string, std::string> environment;  // added to that of the test
  std::string out_path;                            // standard output goes there instead
  bool close_out = false;                          // no standard output at all
  std::size_t max_file_size = 0;                   // bytes; 0 for no limit
  std::size_t max_memory = 0;                      // bytes of address space; 0 for no limit
};

// A folder of one test, gone after it; programs run inside it.
class TestFolder {
 public:
  TestFolder();
  ~TestFolder();
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  // `command` begins with the name of a program of ours, or with any other program's path.
  ProgramResult run(const std::vector<std::string>& command, const RunOptions& options = {}) const;

  std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  std::string read(const std::string& name) const;
  void write(const std::string& name, const std::string& bytes) const;
  // Names of what is in the folder, sorted.
  std::vector<std::string> names() const;

 private:
  std::filesystem::path folder_;
};

// A program that runs while the test goes on, its standard error a pipe or a terminal.
class RunningProgram {
 public:
  enum class ErrorStream { pipe, terminal };

  RunningProgram(const TestFolder& folder, const std::vector<std::string>& command,
                 ErrorStream stream);
  ~RunningProgram();
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  // Waits until the program catches the signal; false if it ended before.
  bool wait_until_caught(int signal_number) const;
  // Reads standard error until it has that text; false if it ended without.
  bool read_error_until(const std::string& text);
  void send(int signal_number) const;
  // Reads the rest of standard error and waits for the end.
  ProgramResult finish();

 private:
  bool read_some();

  pid_t process_ = -1;
  int error_stream_ = -1;
  std::string error_text_;
};

}  // namespace dapple
