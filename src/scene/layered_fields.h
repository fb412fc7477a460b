// The numbers of a layered material in one list: their names and what they may be.
#pragma once

#include <span>
#include <string_view>

#include "scene/layered_material.h"

namespace dapple {

// A number must be finite and in [low, high], unless it says otherwise.
struct LayeredNumber {
  std::string_view name;
  float LayeredMaterial::*member;
  float low = 0;
  float high = std::numeric_limits<float>::max();
};
// Each component must be finite and in [0, high].
struct LayeredColour {
  std::string_view name;
  Vec3f LayeredMaterial::*member;
  float high = std::numeric_limits<float>::max();
};

// Both in the order of LayeredMaterial.
[[nodiscard]] std::span<const LayeredNumber> layered_numbers();
[[nodiscard]] std::span<const LayeredColour> layered_colours();

[[nodiscard]] std::string_view map_name(MapUse use);
[[nodiscard]] std::string_view name_of(BaseModel model);
[[nodiscard]] std::string_view name_of(AlphaMode mode);

}  // namespace dapple
