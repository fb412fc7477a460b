// Whether there is anything to be seen, before a picture is made.
#pragma once

#include "render/prepared_scene.h"
#include "render/settings.h"

namespace dapple {

// False when no surface is met by the rays through the centres of pixels, or of as many of them as
// can be tried in no time. The camera's axes must not be degenerate.
[[nodiscard]] bool sees_surfaces(const PreparedScene& scene, const RenderSettings& settings);

// True when the camera stands inside of a closed surface with a medium, which paths that begin at
// it know nothing of: in directions all round the nearest such surface is met from within. False
// for classic scenes.
[[nodiscard]] bool stands_in_medium(const PreparedScene& scene);

}  // namespace dapple
