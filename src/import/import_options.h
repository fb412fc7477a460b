// What a user can ask of an import; every format takes what concerns it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace dapple {

struct ImportOptions {
  std::string scene;           // of a file with several: name or index; empty: the file's default
  std::string camera;          // name or index; empty: the first
  std::string variant;         // of the materials, by name; empty: the file's own materials
  std::optional<double> time;  // seconds into the animations; without: the stored pose
  bool keep_going = false;     // what is missing or broken becomes a warning where that is possible
  double point_radius = 0;     // of points, and of lines; 0: from the size of what is shown
  std::uint64_t max_bytes = 8ull << 30;  // memory that what is imported may take
};

}  // namespace dapple
