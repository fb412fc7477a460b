#include "classic/classic_program.h"
#include "common/standard_output.h"
#include "scene/describe.h"
#include "scene_file/mapped_scene.h"

namespace dapple {

Status classic_describe(const ClassicArguments& arguments) {
  const auto scene = MappedScene::open(arguments.values[0]);
  if (!scene) return tl::unexpected(scene.error());
  if (arguments.flags.contains("json")) return describe_json(scene->view(), print_output);
  const auto detail =
      arguments.flags.contains("full") ? DescribeDetail::full : DescribeDetail::objects;
  return describe(scene->view(), detail, print_output);
}

}  // namespace dapple
