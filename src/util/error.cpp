#include "util/error.h"

#include <system_error>
#include <utility>

namespace dapple {

std::string to_string(const Error& error) {
  return error.place.empty() ? error.message : error.place + ": " + error.message;
}

tl::unexpected<Error> fail(Errc code, std::string place, std::string message) {
  return tl::unexpected<Error>(Error{code, std::move(message), std::move(place)});
}

std::string errno_text(int error_number) { return std::generic_category().message(error_number); }

}  // namespace dapple
