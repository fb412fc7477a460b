// A scene file mapped into memory and proven: its arrays are read where they lie.
#pragma once

#include <string>

#include "scene_file/verify.h"
#include "util/mapped_file.h"

namespace dapple {

class MappedScene {
 public:
  // Errors are placed at the path: it cannot be opened (no_input), or it is empty, damaged, foreign
  // or of another version (bad_data).
  [[nodiscard]] static Expected<MappedScene> open(const std::string& path,
                                                  const VerifyOptions& options = {});

  const SceneView& view() const { return scene_.view; }
  const PictureShape& pictures() const { return scene_.pictures; }
  // False when only what a rendering through the BVH reads was asked for: then the shapes of the
  // view may be counted but not read.
  bool shapes_verified() const { return scene_.shapes_verified; }

 private:
  MappedScene(MappedFile file, VerifiedScene scene)
      : file_(std::move(file)), scene_(std::move(scene)) {}

  MappedFile file_;
  VerifiedScene scene_;
};

}  // namespace dapple
