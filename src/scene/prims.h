// Primitives as the acceleration structures see them: single precision, numbered through.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "math/bounds3.h"
#include "scene/scene_view.h"

namespace dapple {

[[nodiscard]] Bounds3f sphere_bounds(const Sphere& sphere);
[[nodiscard]] Bounds3f rectangle_bounds(ShapeKind kind, const Rectangle& rectangle);

[[nodiscard]] Bounds3f triangle_bounds(const SceneView& scene, const Triangle& triangle);
[[nodiscard]] Bounds3f cylinder_bounds(const Cylinder& cylinder);
// Of an instance in the world, around a prototype with that box. Finite even for an empty one.
[[nodiscard]] Bounds3f instance_bounds(const Transformf& to_world, const Bounds3f& prototype);

// The box of each prototype: what the box of an instance is made from.
using PrototypeBoxes = std::vector<Bounds3f>;
[[nodiscard]] PrototypeBoxes prototype_boxes(const SceneView& scene);

// Of any shape. Only instances need the boxes of prototypes, here and below.
[[nodiscard]] Bounds3f shape_bounds(const SceneView& scene, const PrototypeBoxes& prototypes,
                                    ShapeKind kind, std::size_t index);

// Of all that stands in the world.
[[nodiscard]] Bounds3f scene_bounds(const SceneView& scene);

// Makes a leaf of no primitives out of `leaf_rows(kind, form)` rows.
void clear_leaf(ShapeKind kind, LeafRow* leaf, LeafForm form = LeafForm::whole);

// Writes shape `index` of `kind` as primitive `id` into a lane of the leaf that begins at `leaf`.
void write_lane(const SceneView& scene, const PrototypeBoxes& prototypes, ShapeKind kind,
                std::size_t index, PrimId id, LeafRow* leaf, std::size_t lane,
                LeafForm form = LeafForm::whole);

}  // namespace dapple
