#include "classic_render.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>

#include "image/formats.h"
#include "render/render_job.h"
#include "scene_file/scene_source.h"
#include "util/mapped_ranges.h"
#include "util/parse_number.h"

namespace dapple {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Status run(int argc, char** argv, AccelKind kind) {
  RenderSettings settings;
  int* const numbers[3] = {&settings.width, &settings.height, &settings.samples_per_pixel};
  const char* const names[3] = {"NX", "NY", "NS"};
  for (int i = 0; i < 3; ++i) {
    const auto value = parse_integer(argv[2 + i], names[i], 1, kMaxSamplesPerPixel);
    if (!value) return tl::unexpected(value.error());
    *numbers[i] = static_cast<int>(*value);
  }
  VerifyOptions options_of_file;
  if (kind == AccelKind::fast) options_of_file.scope = VerifyScope::bvh_only;
  const auto scene = SceneSource::open(argc > 5 ? argv[5] : "nice", options_of_file);
  if (!scene) return tl::unexpected(scene.error());
  auto start = std::chrono::steady_clock::now();
  const PreparedScene prepared(scene->view(), make_accel(kind, scene->view()));
  if (kind != AccelKind::linear) {
    fmt::print("Scene BVH construction in {:f}s.\n", seconds_since(start));
  }
  start = std::chrono::steady_clock::now();
  const auto result = render(prepared, settings);
  if (!result) return tl::unexpected(result.error());
  fmt::print("Rendering in {:f}s.\n", seconds_since(start));
  ImageWriteOptions options;
  options.transfer = Transfer::gamma2;
  return write_image(argv[1], result->image, options);
}

}  // namespace

int run_classic_render(int argc, char** argv, AccelKind kind) {
  if (argc < 5 || argc > 6) {
    fmt::print(stderr, "usage: {} OUTFILE NX NY NS [SCENE]\n", argv[0]);
    return 2;
  }
  exit_when_mapped_file_shrinks(1);
  const Status status = run(argc, argv, kind);
  if (status) return 0;
  fmt::print(stderr, "{}: {}\n", argv[0], to_string(status.error()));
  return status.error().code == Errc::usage ? 2 : 1;
}

}  // namespace dapple
