// Joins the corners of separate triangles that lie at exactly the same position.
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

#include "import/mesh_data.h"
#include "util/hash.h"

namespace dapple::stl {

class Weld {
 public:
  // `triangle_count`: how many to expect.
  Weld(MeshData& mesh, std::size_t triangle_count) : mesh_(mesh) {
    mesh.triangles.reserve(triangle_count);
    grow(triangle_count / 2 + 16);  // closed meshes have half as many vertices as triangles
  }

  void add(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
    mesh_.triangles.push_back({{vertex(a), vertex(b), vertex(c)}});
  }

 private:
  static constexpr std::uint32_t kFree = 0xffffffffu;

  // By their bits: NaN equals itself, and minus zero is not zero.
  static bool same(const Vec3f& a, const Vec3f& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

  std::uint32_t vertex(const Vec3f& position) {
    auto& positions = mesh_.vertices.positions;
    if (2 * positions.size() >= slots_.size()) grow(2 * positions.size());
    std::size_t at = slot(position);
    while (slots_[at] != kFree) {
      if (same(positions[slots_[at]], position)) return slots_[at];
      at = (at + 1) & (slots_.size() - 1);
    }
    slots_[at] = static_cast<std::uint32_t>(positions.size());
    positions.push_back(position);
    return slots_[at];
  }

  std::size_t slot(const Vec3f& position) const {
    return hash_bytes(std::as_bytes(std::span(&position, 1))) & (slots_.size() - 1);
  }

  void grow(std::size_t vertices) {
    std::size_t size = 64;
    while (size < 2 * vertices) size *= 2;
    slots_.assign(size, kFree);
    const auto& positions = mesh_.vertices.positions;
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
      std::size_t at = slot(positions[i]);
      while (slots_[at] != kFree) at = (at + 1) & (size - 1);
      slots_[at] = i;
    }
  }

  MeshData& mesh_;
  std::vector<std::uint32_t> slots_;  // open addressing, at most half full; a power of two
};

}  // namespace dapple::stl
