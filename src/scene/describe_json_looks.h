// The parts of a description in JSON that are about how things look.
#pragma once

#include "scene/scene_view.h"
#include "util/text_sink.h"

namespace dapple {

// `{"lookfrom":...}`
void print_json_camera(const Camera& camera, TextWriter& out);

// "materials", "layered_materials", "textures", "images", "lights", "environment" and "cameras",
// with a comma after each.
void print_json_looks(const SceneView& scene, TextWriter& out);

}  // namespace dapple
