// The text of the repository, as the tests of its architecture see it.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace dapple::architecture {

// Path from the repository's root, with '/', to the file's text. Plain data, so that a test can
// make up a repository.
using SourceTree = std::map<std::string, std::string>;

// The files below these folders or with these names, of the repository at `root`.
SourceTree read_source_tree(const std::string& root, const std::vector<std::string>& places);

// The folder names of a path and its file name: "src/math/ray.h" gives {"src", "math", "ray.h"}.
std::vector<std::string> path_parts(std::string_view path);

std::vector<std::string> lines_of(const std::string& text);

// A line without its // comment. Text in string literals is not told apart.
std::string without_comment(const std::string& line);
// Only its // comment, or nothing.
std::string comment_of(const std::string& line);

}  // namespace dapple::architecture
