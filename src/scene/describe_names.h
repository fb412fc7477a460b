// The words for kinds of textures, lights and surroundings.
#pragma once

#include <string_view>

#include "scene/camera.h"
#include "scene/light.h"
#include "scene/texture.h"

namespace dapple {

inline std::string_view name_of(TexelFormat format) {
  constexpr std::string_view kNames[] = {"rgba8", "rgba16", "rgb32f"};
  return kNames[static_cast<std::size_t>(format)];
}
inline std::string_view name_of(Wrap wrap) {
  constexpr std::string_view kNames[] = {"repeat", "mirrored_repeat", "clamp_to_edge"};
  return kNames[static_cast<std::size_t>(wrap)];
}
inline std::string_view name_of(Filter filter) {
  return filter == Filter::linear ? "linear" : "nearest";
}
inline std::string_view name_of(LightKind kind) {
  constexpr std::string_view kNames[] = {"point", "spot", "directional"};
  return kNames[static_cast<std::size_t>(kind)];
}
inline std::string_view name_of(EnvironmentKind kind) {
  constexpr std::string_view kNames[] = {"classic_sky", "none", "constant", "image", "studio"};
  return kNames[static_cast<std::size_t>(kind)];
}
inline std::string_view name_of(const NamedCamera& camera) { return camera.name.data(); }

}  // namespace dapple
