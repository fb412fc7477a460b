// Instances as rays meet them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "accel/prepared_ray.h"
#include "math/transform.h"
#include "scene/scene_view.h"

namespace dapple {

struct PlacedInstance {
  Transformf to_world;
  Transformf to_object;
  std::uint32_t content = kNothing;  // where a structure keeps the prototype

  static constexpr std::uint32_t kNothing = 0xffffffffu;
};

// contents[p] is where prototype p is kept. An instance whose map has no inverse shows nothing.
[[nodiscard]] std::vector<PlacedInstance> place_instances(const SceneView& scene,
                                                          std::span<const std::uint32_t> contents);

// The ray in the prototype's space. Its direction is not of unit length: distances along it are
// those along the ray in the world. What is rounded here is rounded the same for every structure.
[[nodiscard]] Ray enter_instance(const PlacedInstance& instance, const float origin[3],
                                 const float direction[3]);
[[nodiscard]] PreparedRay enter_instance(const PlacedInstance& instance, const PreparedRay& ray);

}  // namespace dapple
