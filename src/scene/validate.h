// What must hold of a scene before anything is stored or rendered.
#pragma once

#include "scene/scene_view.h"
#include "util/error.h"

namespace dapple {

// Beyond this, squares of coordinates would overflow the single precision of the ray kernels.
inline constexpr double kMaxCoordinate = 1e18;
inline constexpr std::size_t kMaxObjectCount = 1u << 31;

// Array lengths agree, material ids are below the number of materials, numbers are finite,
// coordinates below kMaxCoordinate in magnitude. The error's place is the object's or
// material's index ("object 3", "material 0", "camera").
[[nodiscard]] Status validate(const SceneView& scene);
// The part of it that is about numbers of objects: runs, array lengths, kMaxObjectCount.
[[nodiscard]] Status validate_counts(const SceneView& scene);
[[nodiscard]] Status validate(const Camera& camera);
[[nodiscard]] Status validate(const Material& material);

// True when the numbers of a shape are finite and small enough.
[[nodiscard]] bool is_valid(const Sphere& sphere);
[[nodiscard]] bool is_valid(const Rectangle& rectangle);

}  // namespace dapple
