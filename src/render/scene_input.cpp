#include "render/scene_input.h"

#include <utility>

#include "import/registry.h"
#include "render/framing.h"
#include "scene/prims.h"
#include "scene/validate.h"

namespace dapple {
namespace {

constexpr double kUsualAspect = 4.0 / 3.0;  // of a picture whose size is not known yet

Expected<SceneInput> import_input(const std::string& path, const ImportOptions& options) {
  auto imported = import_scene(path, options);
  if (!imported) return tl::unexpected(imported.error());
  if (auto status = validate(imported->scene); !status) {
    Error error = status.error();
    error.place = error.place.empty() ? path : path + ": " + error.place;
    return tl::unexpected(std::move(error));
  }
  const bool has_camera = !imported->scene.cameras.empty();
  if (!has_camera) {
    imported->scene.camera = frame_scene(scene_bounds(imported->scene), kUsualAspect);
  }
  return SceneInput{SceneSource::of(std::move(imported->scene)),
                    has_camera,
                    std::move(imported->warnings),
                    imported->resolution,
                    std::move(imported->camera_aspects),
                    true};
}

}  // namespace

Expected<SceneInput> open_scene_input(const std::string& name_or_path, const VerifyOptions& verify,
                                      const ImportOptions& import) {
  if (SceneSource::is_path(name_or_path) && is_importable(name_or_path)) {
    return import_input(name_or_path, import);
  }
  auto source = SceneSource::open(name_or_path, verify);
  if (!source) return tl::unexpected(source.error());
  return SceneInput{std::move(*source), true, {}};
}

}  // namespace dapple
