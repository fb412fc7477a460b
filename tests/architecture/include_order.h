// Who may include whom.
#pragma once

#include <string>
#include <vector>

#include "tests/architecture/source_tree.h"

namespace dapple::architecture {

// The modules of src/ from the bottom to the top; those of one layer do not know each other.
const std::vector<std::vector<std::string>>& module_layers();

// One line "FILE: reason" for each include that goes against the order:
//  - a file of src/ includes its own module and lower layers; the C interface and what stands on
//    the library also include the installed headers;
//  - a file of apps/ includes apps/, src/ and the installed headers;
//  - an installed header includes the language's headers and other installed headers.
std::vector<std::string> include_violations(const SourceTree& tree);

}  // namespace dapple::architecture
