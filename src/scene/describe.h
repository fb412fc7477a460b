// A scene in words: the text that people read and the JSON that programs read.
#pragma once

#include "scene/scene_view.h"
#include "util/text_sink.h"

namespace dapple {

enum class DescribeDetail {
  objects,  // each object in stored order, triangles that follow each other as one, without radii
  full,     // the camera and the counts first, the radii of spheres, and at the end prototypes,
            // textures, lights, the environment and further cameras
};

// The scene must be valid (scene/validate.h). Memory stays small however large the scene is.
[[nodiscard]] Status describe(const SceneView& scene, DescribeDetail detail, const TextSink& sink);

// Everything the scene says, as one JSON object with a line for each object; numbers read back
// bit for bit. Of vertices, triangles and texels only how many there are, and where.
[[nodiscard]] Status describe_json(const SceneView& scene, const TextSink& sink);

}  // namespace dapple
