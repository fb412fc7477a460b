// Vertices out of corners whose attributes have indices of their own.
#pragma once

#include <cstdint>
#include <vector>

namespace dapple {

// Numbers the different triples (position, uv, normal) in the order in which they come first.
class CornerTable {
 public:
  struct Vertex {
    std::uint32_t position = 0, uv = 0, normal = 0;
    std::uint32_t next = 0;  // of the same position
  };

  explicit CornerTable(std::size_t position_count) : first_(position_count, kEnd) {}

  std::uint32_t vertex(std::uint32_t position, std::uint32_t uv, std::uint32_t normal) {
    int steps = 0;
    for (std::uint32_t v = first_[position]; v != kEnd; v = vertices_[v].next) {
      if (vertices_[v].uv == uv && vertices_[v].normal == normal) return v;
      // A position with this many vertices is made up: a double one more does no harm, but walking
      // them all for each corner would.
      if (++steps == kMaxSteps) break;
    }
    const auto v = static_cast<std::uint32_t>(vertices_.size());
    vertices_.push_back({position, uv, normal, first_[position]});
    first_[position] = v;
    return v;
  }

  const std::vector<Vertex>& vertices() const { return vertices_; }

 private:
  static constexpr std::uint32_t kEnd = 0xffffffffu;
  static constexpr int kMaxSteps = 64;

  std::vector<std::uint32_t> first_;  // vertex of each position
  std::vector<Vertex> vertices_;
};

}  // namespace dapple
