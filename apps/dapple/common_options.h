// Options that several subcommands share.
#pragma once

#include "dapple/arguments.h"
#include "scene_file/scene_source.h"

namespace dapple {

// --threads, and what the environment says about kernels.
[[nodiscard]] Status set_up_computing(const Arguments& arguments);

// SCENE, read as --trust says.
[[nodiscard]] Expected<SceneSource> open_scene(const Arguments& arguments,
                                               VerifyScope scope = VerifyScope::everything);

}  // namespace dapple
