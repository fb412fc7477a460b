// Camera and film of a pbrt scene.
#pragma once

#include <array>
#include <string>

#include "import/pbrt/context.h"
#include "scene/camera.h"

namespace dapple::pbrt {

struct Film {
  int width = 1280;
  int height = 720;
};

[[nodiscard]] Expected<Film> make_film(const Context& context, const Params& params);

// True when the camera's right, up and forward form a left-handed frame, as pbrt's own do.
[[nodiscard]] bool is_left_handed(const Transformd& camera_from_world);

// `camera_from_world` must have an inverse; the result stands in the scene's coordinates.
[[nodiscard]] Camera make_camera(const Context& context, const Transformd& camera_from_world,
                                 const std::string& kind, const Params& params, const Film& film);

}  // namespace dapple::pbrt
