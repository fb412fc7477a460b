// What must hold of a scene before anything is stored or rendered.
#pragma once

#include "scene/scene_view.h"
#include "util/error.h"

namespace dapple {

// Beyond this, squares of coordinates would overflow the single precision of the ray kernels.
inline constexpr double kMaxCoordinate = 1e18;
inline constexpr std::size_t kMaxObjectCount = 1u << 31;
// Paths keep an index of a material and what else there is to say in one word.
inline constexpr std::size_t kMaxMaterialCount = 1u << 28;
// Hits say in one word through which instance they are seen.
inline constexpr std::size_t kMaxInstanceCount = (1u << 28) - 1;
// How far the squared length of a unit vector may be from 1: what 8 bits a component make of it.
inline constexpr float kUnitTolerance = 0.05f;

// Array lengths agree, indices are below the count of what they point at, prototypes tile the last
// triangles and images the texels, numbers are finite and in range, coordinates below
// kMaxCoordinate in magnitude, transforms have inverses. In parallel. The error's place is the
// object's or other element's index ("object 3", "material 0", "vertex normal 7", "camera").
[[nodiscard]] Status validate(const SceneView& scene);
// The part of it that is about numbers of things: runs, array lengths, greatest counts.
[[nodiscard]] Status validate_counts(const SceneView& scene);
[[nodiscard]] Status validate(const Camera& camera);
[[nodiscard]] Status validate(const Material& material);

// True when the numbers of a shape are finite and small enough.
[[nodiscard]] bool is_valid(const Sphere& sphere);
[[nodiscard]] bool is_valid(const Rectangle& rectangle);
[[nodiscard]] bool is_valid(const Cylinder& cylinder);
// Finite and small, and so is its inverse, when computed in double precision.
[[nodiscard]] bool is_valid(const Transformf& transform);

}  // namespace dapple
