#include "common/standard_output.h"
#include "dapple/commands.h"
#include "dapple/common_options.h"
#include "scene/describe.h"

namespace dapple {

Expected<int> run_info(const Arguments& arguments) {
  const auto scene = open_scene(arguments);
  if (!scene) return tl::unexpected(scene.error());
  const Status status = arguments.given("json")
                            ? describe_json(scene->view(), print_output)
                            : describe(scene->view(), DescribeDetail::full, print_output);
  return status.map([] { return 0; });
}

}  // namespace dapple
