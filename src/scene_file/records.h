// The small sections between their form in a file and in memory. Shapes, ids and the BVH need
// none of this: they are the same in both.
#pragma once

#include "scene/picture_shape.h"
#include "scene/scene.h"
#include "scene_file/format.h"
#include "util/error.h"

namespace dapple {

[[nodiscard]] CameraRecord encode(const Camera& camera);
[[nodiscard]] MaterialRecord encode(const Material& material);
[[nodiscard]] RunRecord encode(const ObjectRun& run);
[[nodiscard]] FilmRecord encode(const std::array<int, 2>& film);

// Errors say what is wrong with the record, not where it is.
[[nodiscard]] Expected<Camera> decode_camera(const CameraRecord& record);
[[nodiscard]] Expected<Material> decode_material(const MaterialRecord& record);
// A side that is too long stays too long, whatever it is: reason_against() finds it.
[[nodiscard]] std::array<int, 2> decode_film(const FilmRecord& record);

}  // namespace dapple
