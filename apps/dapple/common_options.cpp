#include "dapple/common_options.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "accel/kernels/dispatch.h"
#include "common/program.h"
#include "dapple/view_arguments.h"
#include "parallel/parallel.h"

namespace dapple {
namespace {

Status check_import_options(const Arguments& arguments, const SceneInput& input) {
  if (input.imported) return {};
  for (const char* name : {"scene", "variant", "time", "point-radius"}) {
    if (!arguments.given(name)) continue;
    return fail(
        Errc::usage, fmt::format("--{}", name),
        fmt::format("does not apply to {}, which is not a model file", arguments.text("SCENE")));
  }
  return {};
}

}  // namespace

Status check_not_input(const std::string& output, const std::string& input) {
  std::error_code none_such;
  if (!std::filesystem::equivalent(output, input, none_such)) return {};
  return fail(Errc::usage, output, "the output would replace an input");
}

Status set_up_computing(const Arguments& arguments) {
  set_thread_count(arguments.small_integer("threads"));
  return check_isa_override();
}

Expected<SceneInput> open_scene(const Arguments& arguments, VerifyScope scope) {
  VerifyOptions options;
  options.hashes = !arguments.given("trust");
  options.copy = arguments.given("copy");
  options.scope = scope;
  auto input = open_scene_input(arguments.text("SCENE"), options, import_options_from(arguments));
  if (!input) return input;
  if (auto status = check_import_options(arguments, *input); !status) {
    return tl::unexpected(status.error());
  }
  for (const std::string& warning : input->warnings) {
    print_message(fmt::format("dapple: warning: {}\n", warning));
  }
  return input;
}

}  // namespace dapple
