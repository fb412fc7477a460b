#include <fmt/format.h>

#include "accel/accel.h"
#include "accel/wide_builder.h"
#include "common/program.h"
#include "common/stop_signal.h"
#include "dapple/commands.h"
#include "dapple/common_options.h"
#include "scene_file/writer.h"

namespace dapple {

Expected<int> run_convert(const Arguments& arguments) {
  if (arguments.given("bvh") && arguments.given("no-bvh")) {
    return fail(Errc::usage, "--no-bvh", "not together with --bvh");
  }
  catch_stop_signals();
  const std::string output = arguments.text("output");
  if (auto status = set_up_computing(arguments).and_then([&] { return check_output(output); });
      !status) {
    return tl::unexpected(status.error());
  }
  const auto source = open_scene(arguments);
  if (!source) return tl::unexpected(source.error());
  if (source->imported) {
    if (auto status = check_not_input(output, arguments.text("SCENE")); !status) {
      return tl::unexpected(status.error());
    }
  }
  SceneView scene = source->view();
  WideBvh built;
  if (arguments.given("no-bvh")) {
    scene.bvh = {};
  } else if (scene.bvh.empty()) {
    built =
        build_wide_bvh(scene, nullptr, parse_bvh_quality(arguments.text("bvh-quality")).value());
    scene.bvh = built.view();
  }
  if (auto status =
          check_stop().and_then([&] { return store_scene_file(output, scene, source->pictures); });
      !status) {
    return tl::unexpected(status.error());
  }
  if (!arguments.given("quiet")) {
    print_message(fmt::format("{}: {} objects {} BVH\n", output, scene.object_count(),
                              scene.bvh.empty() ? "without" : "with"));
  }
  return 0;
}

}  // namespace dapple
