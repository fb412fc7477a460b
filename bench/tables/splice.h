// Puts generated text into a document that people write.
#pragma once

#include <string>

#include "util/error.h"

namespace dapple::bench {

// Replaces what stands between the lines "<!-- begin NAME -->" and "<!-- end NAME -->" by `text`.
// A document without that pair is left as it is; a begin without an end is an error.
[[nodiscard]] Status splice(const std::string& name, const std::string& text,
                            std::string& document);

}  // namespace dapple::bench
