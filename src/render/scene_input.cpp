#include "render/scene_input.h"

#include <fmt/format.h>

#include <cstring>
#include <utility>

#include "import/registry.h"
#include "render/framing.h"
#include "scene/prims.h"
#include "scene/validate.h"

namespace dapple {
namespace {

constexpr double kUsualAspect = 4.0 / 3.0;  // of a picture whose size is not known yet

// Texels that are not finite would be in every sample that they are near to, and in the densities
// of an environment.
Status mend_texels(ImportResult& imported, bool keep_going) {
  Scene& scene = imported.scene;
  for (std::size_t i = 0; i < scene.images.size(); ++i) {
    const TextureImage& image = scene.images[i];
    if (image.format != TexelFormat::rgb32f) continue;
    std::size_t bad = 0, first = 0;
    for (std::uint64_t at = 0; at < image.bytes(); at += sizeof(Vec3f)) {
      Vec3f texel;
      std::uint8_t* bytes = scene.texels.data() + image.offset + at;
      std::memcpy(&texel, bytes, sizeof(texel));
      if (is_finite(texel)) continue;
      if (bad++ == 0) first = at / sizeof(Vec3f);
      std::memset(bytes, 0, sizeof(texel));
    }
    if (bad == 0) continue;
    const std::string where =
        fmt::format("{} texels of image {} are not finite, the first in column {}, row {}", bad, i,
                    first % image.width, first / image.width);
    if (!keep_going) return fail(Errc::bad_data, "", where);
    imported.warnings.push_back(where + "; they are black");
  }
  return {};
}

Expected<SceneInput> import_input(const std::string& path, const ImportOptions& options) {
  auto imported = import_scene(path, options);
  if (!imported) return tl::unexpected(imported.error());
  if (auto status = validate(imported->scene); !status) {
    Error error = status.error();
    error.place = error.place.empty() ? path : path + ": " + error.place;
    return tl::unexpected(std::move(error));
  }
  if (auto status = mend_texels(*imported, options.keep_going); !status) {
    return fail(status.error().code, path, status.error().message);
  }
  const bool has_camera = !imported->scene.cameras.empty();
  if (!has_camera) {
    imported->scene.camera = frame_scene(scene_bounds(imported->scene), kUsualAspect);
  }
  return SceneInput{SceneSource::of(std::move(imported->scene)), has_camera,
                    std::move(imported->warnings), std::move(imported->pictures), true};
}

}  // namespace

Expected<SceneInput> open_scene_input(const std::string& name_or_path, const VerifyOptions& verify,
                                      const ImportOptions& import) {
  if (SceneSource::is_path(name_or_path) && is_importable(name_or_path)) {
    return import_input(name_or_path, import);
  }
  auto source = SceneSource::open(name_or_path, verify);
  if (!source) return tl::unexpected(source.error());
  PictureShape pictures = source->pictures();
  return SceneInput{std::move(*source), true, {}, std::move(pictures)};
}

}  // namespace dapple
