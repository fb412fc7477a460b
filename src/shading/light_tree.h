// A tree of lights that chooses one in proportion to what it may contribute [ContyK18].
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "shading/light_bounds.h"

namespace dapple {

class LightTree {
 public:
  LightTree() = default;
  // Lights without power are never chosen.
  explicit LightTree(std::span<const LightBounds> lights);

  struct Choice {
    std::uint32_t light = 0;
    float probability = 0;
  };
  // No value where no light can contribute.
  std::optional<Choice> choose(const Vec3f& position, const Vec3f& normal, float u) const;
  float probability(const Vec3f& position, const Vec3f& normal, std::uint32_t light) const;

  bool empty() const { return nodes_.empty(); }
  // Of all lights together; see light_bounds.h.
  float total_importance(const Vec3f& position, const Vec3f& normal) const;

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;

  // The first child follows its parent.
  struct Node {
    LightBounds bounds;
    std::uint32_t parent = kNone;
    std::uint32_t second_child = kNone;  // of an inner node
    std::uint32_t light = kNone;         // of a leaf
  };

  std::uint32_t build(std::span<const LightBounds> lights, std::span<std::uint32_t> ids,
                      std::uint32_t parent);
  // Of choosing a node's first child.
  std::optional<float> first_probability(const Node& node, std::uint32_t index,
                                         const Vec3f& position, const Vec3f& normal) const;

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> leaf_of_;  // by light
};

}  // namespace dapple
