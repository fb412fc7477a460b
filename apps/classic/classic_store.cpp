#include "classic/classic_program.h"
#include "common/program.h"
#include "common/stop_signal.h"
#include "scene_file/scene_source.h"
#include "scene_file/writer.h"

namespace dapple {

Status classic_store(const ClassicArguments& arguments) {
  catch_stop_signals();
  const std::string& output = arguments.values[0];
  if (auto status = check_output(output); !status) return status;
  const auto source = SceneSource::open(arguments.values[1]);
  if (!source) return tl::unexpected(source.error());
  SceneView scene = source->view();
  scene.bvh = {};  // the scene as it was given, nothing derived
  return check_stop().and_then([&] { return store_scene_file(output, scene); });
}

}  // namespace dapple
