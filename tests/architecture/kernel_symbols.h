// Which functions an object file offers to every other one.
#pragma once

#include <string>
#include <vector>

namespace dapple::architecture {

// The weak functions in the output of `nm -C --defined-only OBJECT` that are not in a namespace of
// one instruction set (Highway's N_SSE4, N_AVX2, ...).
//
// Of the copies of a weak function that several objects define the linker keeps any one for all of
// them. A file of kernels compiles parts of itself for AVX2 or AVX-512; a weak function that came
// out of such a part under a common name could thus end up in programs on processors that lack
// the instructions.
std::vector<std::string> shared_weak_functions(const std::string& nm_output);

// Whether anything in it is in such a namespace.
bool holds_kernels(const std::string& nm_output);

// What nm prints for this object file. Throws when nm fails.
std::string run_nm(const std::string& object);

}  // namespace dapple::architecture
