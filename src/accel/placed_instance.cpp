#include "accel/placed_instance.h"

#include <cmath>

namespace dapple {
namespace {

bool is_finite(const Transformf& map) {
  for (const auto& row : map.rows) {
    for (const float number : row) {
      if (!std::isfinite(number)) return false;
    }
  }
  return true;
}

Transformd widen(const Transformf& map) {
  Transformd wide;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j) wide.rows[i][j] = double{map.rows[i][j]};
  }
  return wide;
}

Transformf narrow(const Transformd& map) {
  Transformf narrow;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j) narrow.rows[i][j] = static_cast<float>(map.rows[i][j]);
  }
  return narrow;
}

}  // namespace

std::vector<PlacedInstance> place_instances(const SceneView& scene,
                                            std::span<const std::uint32_t> contents) {
  std::vector<PlacedInstance> placed;
  placed.reserve(scene.instances.size());
  for (const Instance& instance : scene.instances) {
    PlacedInstance& in_world = placed.emplace_back();
    in_world.to_world = instance.to_world;
    in_world.to_object = narrow(inverse(widen(instance.to_world)));
    if (is_finite(in_world.to_object)) in_world.content = contents[instance.prototype];
  }
  return placed;
}

Ray enter_instance(const PlacedInstance& instance, const float origin[3],
                   const float direction[3]) {
  Ray inside;
  inside.origin = instance.to_object.point(Vec3f(origin[0], origin[1], origin[2]));
  inside.direction = instance.to_object.vector(Vec3f(direction[0], direction[1], direction[2]));
  return inside;
}

PreparedRay enter_instance(const PlacedInstance& instance, const PreparedRay& ray) {
  Ray inside = enter_instance(instance, ray.origin, ray.direction);
  inside.t_min = ray.t_min;
  inside.t_max = ray.t_max;
  return prepare(inside);
}

}  // namespace dapple
