// Lights of a pbrt scene that are no surfaces.
#pragma once

#include <optional>
#include <string>

#include "import/pbrt/context.h"
#include "scene/light.h"

namespace dapple::pbrt {

// Adds "point", "spot", "distant" and "infinite" lights; others become a warning. `to_world` is the
// transformation where the light stands.
[[nodiscard]] Status add_light(const Context& context, const Transformd& to_world,
                               const std::string& kind, const Params& params);

// Radiance times scale of an area light.
[[nodiscard]] Expected<Vec3f> area_light(const Context& context, const std::string& kind,
                                         const Params& params);

}  // namespace dapple::pbrt
