#include "classic/classic_program.h"
#include "common/scene_argument.h"
#include "common/standard_output.h"
#include "scene/describe.h"

namespace dapple {

Status classic_describe(const ClassicArguments& arguments) {
  const auto scene = SceneSource::open(as_file_path(arguments.values[0]));
  if (!scene) return tl::unexpected(scene.error());
  if (arguments.flags.contains("json")) return describe_json(scene->view(), print_output);
  const auto detail =
      arguments.flags.contains("full") ? DescribeDetail::full : DescribeDetail::objects;
  return describe(scene->view(), detail, print_output);
}

}  // namespace dapple
