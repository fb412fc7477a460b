// Primitives as the acceleration structures see them: single precision, numbered through.
#pragma once

#include <cstdint>

#include "math/bounds3.h"
#include "scene/scene_view.h"

namespace dapple {

[[nodiscard]] Bounds3f sphere_bounds(const Sphere& sphere);
[[nodiscard]] Bounds3f rectangle_bounds(ShapeKind kind, const Rectangle& rectangle);

[[nodiscard]] Bounds3f triangle_bounds(const SceneView& scene, const Triangle& triangle);
// Of any shape.
[[nodiscard]] Bounds3f shape_bounds(const SceneView& scene, ShapeKind kind, std::size_t index);

// Of all that stands in the world.
[[nodiscard]] Bounds3f scene_bounds(const SceneView& scene);

// Makes a leaf of no primitives out of `leaf_rows(kind)` rows.
void clear_leaf(ShapeKind kind, LeafRow* leaf);

// Writes shape `index` of `kind` as primitive `id` into a lane of the leaf that begins at `leaf`.
void write_lane(const SceneView& scene, ShapeKind kind, std::size_t index, PrimId id, LeafRow* leaf,
                std::size_t lane);

}  // namespace dapple
