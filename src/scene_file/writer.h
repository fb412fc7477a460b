// Stores a scene in a file.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "scene/picture_shape.h"
#include "scene/scene_view.h"
#include "util/error.h"

namespace dapple {

// The scene, its BVH when the view has one, and what is known of its pictures' shape, as a file
// that appears whole or not at all. What is stored can be loaded: a scene or BVH that verify()
// would refuse is an error here, and nothing is written. Arrays go to the file from where they lie,
// without another copy of them in memory.
[[nodiscard]] Status store_scene_file(const std::string& path, const SceneView& scene,
                                      const PictureShape& pictures = {});

// The same bytes to wherever `write` puts them, in order. Ends with the first error it returns.
using ByteSink = std::function<Status(std::span<const std::byte>)>;
[[nodiscard]] Status write_scene_bytes(const SceneView& scene, const ByteSink& write,
                                       const PictureShape& pictures = {});

}  // namespace dapple
