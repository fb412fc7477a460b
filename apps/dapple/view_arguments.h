// What a command line says about a model, and how it is to be seen.
#pragma once

#include <array>

#include "dapple/arguments.h"
#include "image/tone_map.h"
#include "import/import_options.h"
#include "render/scene_input.h"
#include "render/settings.h"
#include "render/view_options.h"

namespace dapple {

[[nodiscard]] ImportOptions import_options_from(const Arguments& arguments);
// Errors: a field of view or a radius that is none.
[[nodiscard]] Expected<ViewOptions> view_options_from(const Arguments& arguments);
// Those of --spp and --depth that depend on the scene come from `classic`.
[[nodiscard]] RenderSettings settings_from(const Arguments& arguments, bool classic);
// A usage error when an option is given that classic scenes have no use for.
[[nodiscard]] Status check_classic_options(const Arguments& arguments);
// Width and height: those given. The one that is not given, or both, come from the film that the
// file describes, or from the shape of pictures that its camera is meant for.
[[nodiscard]] Expected<std::array<int, 2>> picture_size(const Arguments& arguments,
                                                        const SceneInput& input,
                                                        const ViewOptions& options);
[[nodiscard]] ToneMap tone_map_from(const Arguments& arguments, bool classic);

}  // namespace dapple
