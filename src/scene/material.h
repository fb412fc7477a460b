// Surface materials: those of the classic scenes, and the layered one of models.
#pragma once

#include <cstdint>
#include <variant>

#include "math/vec3.h"

namespace dapple {

// Index into a scene's materials.
enum class MaterialId : std::uint32_t {};

constexpr std::size_t index_of(MaterialId id) { return static_cast<std::size_t>(id); }

struct Lambertian {
  Vec3d albedo;
  friend bool operator==(const Lambertian&, const Lambertian&) = default;
};

// A mirror whose reflected direction is blurred by `fuzz` times a point of the unit ball.
struct Metal {
  Vec3d albedo;
  double fuzz = 0;
  friend bool operator==(const Metal&, const Metal&) = default;
};

// Clear glass; ref_idx is that of the side the outward normal points away from, over the other.
struct Dielectric {
  double ref_idx = 1;
  friend bool operator==(const Dielectric&, const Dielectric&) = default;
};

// Entry `index` of the scene's layered materials.
struct Layered {
  std::uint32_t index = 0;
  friend bool operator==(const Layered&, const Layered&) = default;
};

// The order is that of the scene file's tags; new materials go at the end.
using Material = std::variant<Lambertian, Metal, Dielectric, Layered>;

}  // namespace dapple
