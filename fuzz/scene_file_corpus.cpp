// scene_file_corpus FOLDER: small scene files to begin fuzzing with, with and without a BVH, and
// models with everything that a file can hold.
#include <fmt/format.h>

#include <cstdio>
#include <string>

#include "accel/wide_builder.h"
#include "scene/named_scenes.h"
#include "scene_file/writer.h"
#include "tests/scene_file/random_model.h"

int main(int argc, char** argv) {
  using namespace dapple;
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
    return 64;
  }
  for (const char* name : {"empty", "nice", "irreg:1", "irreg:5", "rgbbox:3", "spheres:200"}) {
    const auto scene = make_named_scene(name);
    SceneView view = *scene;
    const WideBvh bvh = build_wide_bvh(view);
    for (const bool with_bvh : {false, true}) {
      view.bvh = with_bvh ? bvh.view() : WideBvhView();
      const std::string path = std::string(argv[1]) + "/" + name + (with_bvh ? "-bvh" : "");
      if (const auto status = store_scene_file(path, view); !status) {
        std::fprintf(stderr, "%s\n", to_string(status.error()).c_str());
        return 1;
      }
    }
  }
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const std::string path = fmt::format("{}/model-{}", argv[1], seed);
    if (const auto status = store_scene_file(path, test::random_model(seed)); !status) {
      std::fprintf(stderr, "%s\n", to_string(status.error()).c_str());
      return 1;
    }
  }
  return 0;
}
