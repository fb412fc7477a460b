#include "render/light_path.h"

#include <algorithm>

namespace dapple {

void Insides::enter(MaterialId body) {
  std::shift_right(bodies.begin(), bodies.end(), 1);
  bodies[0] = body;
}

void Insides::leave(MaterialId body) {
  const auto found = std::find(bodies.begin(), bodies.end(), body);
  if (found == bodies.end()) return;
  std::shift_left(found, bodies.end(), 1);
  bodies.back() = kVacuum;
}

void LightPath::add(const Vec3f& contribution, bool indirect, float limit) {
  Vec3f kept = contribution;
  if (indirect && limit > 0) {
    const float largest = std::max({kept.x, kept.y, kept.z});
    if (largest > limit) kept = (limit / largest) * kept;
    const Vec3f removed = contribution - kept;
    clamped += removed.x + removed.y + removed.z;
  }
  radiance = radiance + kept;
}

}  // namespace dapple
