// The frame around every program: process set-up, and outcomes turned into exit codes.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "util/error.h"

namespace dapple {

// Calls the body; running out of memory and other exceptions become errors.
[[nodiscard]] Expected<int> call_guarded(const std::function<Expected<int>()>& body);

// Standard streams that are closed are opened in a way that fails when used, so that no file of
// ours gets their number; a file grown past its limit is an error instead of a signal; a scene
// file that is truncated while it is read ends the process with that exit code.
void prepare_process(int truncation_exit_code);

// From now on a reader who went away is an error instead of a signal: for programs whose real
// work is not what they print.
void survive_closed_pipes();

// Writes to standard error; that it cannot be written there changes nothing.
void print_message(const std::string& text);

// One line on standard error: "PROGRAM: PLACE: MESSAGE".
void report(std::string_view program, const Error& error);

// An output that cannot be created is better known before long work than after it. Nothing is
// left behind, and nothing is written to a device or a pipe.
[[nodiscard]] Status check_output(const std::string& path);

}  // namespace dapple
