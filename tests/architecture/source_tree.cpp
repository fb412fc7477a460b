#include "tests/architecture/source_tree.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace dapple::architecture {
namespace {

namespace fs = std::filesystem;

std::string read_text(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path.string());
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

SourceTree read_source_tree(const std::string& root, const std::vector<std::string>& places) {
  SourceTree tree;
  const auto add = [&](const fs::path& path) {
    tree[fs::relative(path, root).generic_string()] = read_text(path);
  };
  for (const std::string& place : places) {
    const fs::path path = fs::path(root) / place;
    if (fs::is_regular_file(path)) add(path);
    if (!fs::is_directory(path)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(path)) {
      if (entry.is_regular_file()) add(entry.path());
    }
  }
  return tree;
}

std::vector<std::string> path_parts(std::string_view path) {
  std::vector<std::string> parts;
  for (const auto& part : fs::path(path)) parts.push_back(part.string());
  return parts;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string without_comment(const std::string& line) { return line.substr(0, line.find("//")); }

std::string comment_of(const std::string& line) {
  const auto start = line.find("//");
  return start == std::string::npos ? std::string() : line.substr(start);
}

}  // namespace dapple::architecture
