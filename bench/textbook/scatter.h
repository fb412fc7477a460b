// How materials scatter, in double precision.
#pragma once

#include <optional>

#include "textbook/hittable.h"
#include "textbook/random.h"

namespace dapple::textbook {

struct Scattered {
  Vec3d direction;
  Vec3d attenuation;
};

// No value when the ray is absorbed; `direction` is the incoming one, of any length.
[[nodiscard]] std::optional<Scattered> scatter(const HitRecord& at, const Vec3d& direction,
                                               Random& random);

}  // namespace dapple::textbook
