#include "render/light_path.h"

#include <algorithm>

namespace dapple {

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
