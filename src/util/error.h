// Errors that meet the world are values: a code, what went wrong, and where.
#pragma once

#include <string>
#include <tl/expected.hpp>

namespace dapple {

// The numbers are the exit codes of the `dapple` command, after sysexits.h.
enum class Errc : int {
  usage = 64,          // the command line or an argument is wrong
  bad_data = 65,       // an input file is damaged, foreign or too new
  no_input = 66,       // an input file does not exist or cannot be read
  internal = 70,       // a bug in dapple
  memory = 71,         // out of memory
  cannot_create = 73,  // an output cannot be created
  io = 74,             // reading or writing failed half-way
  interrupted = 75,    // stopped by a signal; the same command line can run again
};

struct Error {
  Errc code = Errc::internal;
  std::string message;  // the reason, without a full stop
  std::string place;    // file, file and byte offset, or option; may be empty
};

template <class T>
using Expected = tl::expected<T, Error>;
using Status = Expected<void>;

// One line: "PLACE: MESSAGE".
[[nodiscard]] std::string to_string(const Error& error);

[[nodiscard]] tl::unexpected<Error> fail(Errc code, std::string place, std::string message);

// The text of an errno value, the same on every thread.
[[nodiscard]] std::string errno_text(int error_number);

}  // namespace dapple
