// Rules of the house that a reader of the text can check.
#pragma once

#include <string>
#include <vector>

#include "tests/architecture/source_tree.h"

namespace dapple::architecture {

// Each function gives one line "FILE: reason" or "FILE:LINE: reason" for each offence.

// Files are named in snake_case (with Highway's "-inl" for headers that are compiled once for each
// instruction set); headers are guarded, by #pragma once or in C by a macro.
std::vector<std::string> naming_violations(const SourceTree& tree);

// Nine files of ten have fewer than 300 lines.
std::vector<std::string> length_violations(const SourceTree& tree);

// src/ neither prints nor ends the process; OpenMP stands in parallel/ alone, Highway in
// accel/kernels/ and where the leaves of a file are checked; nothing calls functions of <cmath>
// whose results differ between machines.
std::vector<std::string> forbidden_calls(const SourceTree& tree);

// Keys of papers in comments (a name and two digits in brackets), each an entry of
// docs/references.bib; and entries that nobody cites.
std::vector<std::string> citation_violations(const SourceTree& tree);

// Relative links of Markdown pages lead to a file or folder of the tree.
std::vector<std::string> broken_links(const SourceTree& tree);

}  // namespace dapple::architecture
