// Primitives as the acceleration structures see them: single precision, numbered through.
#pragma once

#include <cstdint>

#include "math/bounds3.h"
#include "scene/scene_view.h"

namespace dapple {

[[nodiscard]] Bounds3f sphere_bounds(const Sphere& sphere);
[[nodiscard]] Bounds3f rectangle_bounds(ShapeKind kind, const Rectangle& rectangle);

[[nodiscard]] Bounds3f scene_bounds(const SceneView& scene);

// Writes shape `index` of `kind` as primitive `lane` of a leaf of `count` that begins at `leaf`.
void write_lane(const SceneView& scene, ShapeKind kind, std::size_t index, PrimId id,
                std::uint32_t* leaf, std::size_t count, std::size_t lane);

}  // namespace dapple
