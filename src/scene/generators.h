// What the named scenes are made of; `size` is the N of `name:N`.
#pragma once

#include <cstdint>

#include "scene/scene.h"

namespace dapple {

[[nodiscard]] Scene make_empty(std::int64_t size);
[[nodiscard]] Scene make_nice(std::int64_t size);
[[nodiscard]] Scene make_irreg(std::int64_t size);
[[nodiscard]] Scene make_rgbbox(std::int64_t size);
[[nodiscard]] Scene make_sphere_cloud(std::int64_t size);

}  // namespace dapple
