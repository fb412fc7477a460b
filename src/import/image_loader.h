// Pictures of a model, decoded in parallel and put into the scene.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "import/import_log.h"
#include "import/scene_builder.h"

namespace dapple {

// A picture's file in memory, and what errors call it.
struct EncodedImage {
  std::span<const std::byte> bytes;
  std::string place;
};

// The number of each picture in the scene. One that cannot be decoded is an error, or with
// `keep_going` a warning and kNoImage.
[[nodiscard]] Expected<std::vector<ImageId>> load_images(const std::vector<EncodedImage>& images,
                                                         bool keep_going, SceneBuilder& builder,
                                                         ImportLog& log);

}  // namespace dapple
