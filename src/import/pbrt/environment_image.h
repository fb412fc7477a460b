// Environment pictures of pbrt as equirectangular ones.
#pragma once

#include <string>

#include "import/pbrt/context.h"
#include "scene/texture.h"

namespace dapple::pbrt {

// A square picture is an equal-area octahedral map [Clarberg08], as pbrt-v4 has them, any other one
// equirectangular with z up, as in pbrt-v3. The result is resampled: turned by `to_scene`, y up,
// its centre column at +x. A missing one is an error, or with `keep_going` a warning and magenta.
[[nodiscard]] Expected<ImageId> environment_image(const Context& context,
                                                  const Transformd& to_scene,
                                                  const std::string& name,
                                                  const std::string& place);

}  // namespace dapple::pbrt
