// The named scenes and their generators: `empty`, `nice`, `irreg[:N]`, `rgbbox[:N]`,
// `spheres[:N]`.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"
#include "util/error.h"

namespace dapple {

struct NamedScene {
  std::string_view name;
  std::string_view summary;
  std::string_view size_meaning;  // what N counts; empty when the scene has one size
};

// In alphabetical order.
[[nodiscard]] const std::vector<NamedScene>& named_scenes();

// True when `text` is a scene's name, alone or followed by ":" and anything.
[[nodiscard]] bool is_scene_name(std::string_view text);

// The scene of that name and size. An unknown name is an error that lists the names; a size that
// is not an integer in range is a usage error.
[[nodiscard]] Expected<Scene> make_named_scene(std::string_view text);

}  // namespace dapple
