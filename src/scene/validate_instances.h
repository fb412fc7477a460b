// What must hold of instances together with what they place.
#pragma once

#include <optional>

#include "scene/scene_view.h"

namespace dapple {

// The first instance that places a vertex of its prototype beyond kMaxCoordinate, roughly: a cube
// around the origin with all vertices in it is taken for them. Every array must be valid.
[[nodiscard]] std::optional<std::size_t> instance_too_far(const SceneView& scene);

}  // namespace dapple
