#include "dapple/common_options.h"

#include "accel/kernels/dispatch.h"
#include "parallel/parallel.h"

namespace dapple {

Status set_up_computing(const Arguments& arguments) {
  set_thread_count(arguments.small_integer("threads"));
  return check_isa_override();
}

Expected<SceneSource> open_scene(const Arguments& arguments, VerifyScope scope) {
  VerifyOptions options;
  options.hashes = !arguments.given("trust");
  options.scope = scope;
  return SceneSource::open(arguments.text("SCENE"), options);
}

}  // namespace dapple
