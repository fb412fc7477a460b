// The parts of a description that are about how things look: materials, textures, lights, cameras.
#pragma once

#include "scene/scene_view.h"
#include "util/text_sink.h"

namespace dapple {

// "layered(base_colour=(...), metallic=..., roughness=...": those three, and what is not as in
// every layered material.
void print_layered(const LayeredMaterial& material, TextWriter& out);
void print_material(const SceneView& scene, MaterialId id, TextWriter& out);
void print_camera(const Camera& camera, TextWriter& out);

// Textures, images, lights, the environment and cameras to choose from, a paragraph each. Nothing
// for what is as in the classic scenes.
void print_looks(const SceneView& scene, TextWriter& out);

}  // namespace dapple
