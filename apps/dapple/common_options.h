// Options that several subcommands share.
#pragma once

#include <string>

#include "dapple/arguments.h"
#include "render/scene_input.h"

namespace dapple {

// --threads, and what the environment says about kernels.
[[nodiscard]] Status set_up_computing(const Arguments& arguments);

// SCENE, read as --trust, --copy and, where the command has them, the options of imports say.
// Warnings of an import are printed.
[[nodiscard]] Expected<SceneInput> open_scene(const Arguments& arguments,
                                              VerifyScope scope = VerifyScope::everything);

// A usage error when the two are the same file.
[[nodiscard]] Status check_not_input(const std::string& output, const std::string& input);

}  // namespace dapple
