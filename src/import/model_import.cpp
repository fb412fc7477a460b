#include "import/model_import.h"

#include <fmt/format.h>

namespace dapple {
namespace {

bool shines(const Scene& scene) {
  if (!scene.lights.empty()) return true;
  for (const LayeredMaterial& material : scene.layered_materials) {
    if (max_abs_component(material.emission) > 1) return true;
  }
  return false;
}

}  // namespace

Expected<ModelImport> ModelImport::open(const std::string& path, const ImportOptions& options) {
  auto file = MappedFile::open(path);
  if (!file) return tl::unexpected(file.error());
  auto sandbox = Sandbox::around(path);
  if (!sandbox) return tl::unexpected(sandbox.error());
  return ModelImport(path, options, std::move(*file), std::move(*sandbox));
}

Expected<MappedFile> ModelImport::open_companion(const std::string& name) const {
  auto file = sandbox_.open(name);
  const std::size_t slash = name.rfind('/');
  if (file || slash == std::string::npos) return file;
  auto beside = sandbox_.open(name.substr(slash + 1));
  return beside ? std::move(beside) : std::move(file);
}

Expected<RawImage> ModelImport::picture(const std::string& name) const {
  if (const auto inside = embedded_.find(name); inside != embedded_.end()) return inside->second;
  const auto file = open_companion(name);
  if (!file) return tl::unexpected(file.error());
  auto image = decode_raw_image(file->bytes(), kMaxImagePixels);
  if (!image) {
    Error error = image.error();
    error.place = sandbox_.path_of(name) + (error.place.empty() ? "" : ", " + error.place);
    return tl::unexpected(error);
  }
  return image;
}

Expected<TextureId> ModelImport::texture(const std::string& name, const std::string& place,
                                         Texture settings) {
  auto known = images_.find(name);
  if (known == images_.end()) {
    const auto image = picture(name).and_then(
        [&](const RawImage& decoded) { return builder_.add_image(decoded); });
    if (!image) return missing(image.error(), place);
    known = images_.emplace(name, *image).first;
  }
  settings.image = known->second;
  return builder_.add_texture(settings);
}

Expected<TextureId> ModelImport::texture(const Expected<RawImage>& picture,
                                         const std::string& place, Texture settings) {
  const auto id =
      picture.and_then([&](const RawImage& image) { return builder_.add_image(image); });
  if (!id) return missing(id.error(), place);
  settings.image = *id;
  return builder_.add_texture(settings);
}

Expected<TextureId> ModelImport::missing(const Error& reason, const std::string& place) {
  const Error error{reason.code, to_string(reason), place};
  if (!options_.keep_going) return tl::unexpected(error);
  log_.warn(to_string(error));
  return builder_.magenta_texture();
}

std::vector<std::string> ModelImport::left_out() const {
  std::vector<std::string> reasons;
  const auto& counts = builder_.left_out();
  if (counts.not_finite > 0) {
    reasons.push_back(
        fmt::format("{} triangles with coordinates that are not finite or too large are left out",
                    counts.not_finite));
  }
  if (counts.without_area > 0) {
    reasons.push_back(fmt::format("{} triangles without area are left out", counts.without_area));
  }
  return reasons;
}

Expected<ImportResult> ModelImport::finish() {
  const auto reasons = left_out();
  if (builder_.is_empty()) {
    std::string message = "holds nothing that can be seen";
    for (const std::string& warning : log_.take()) message += "; " + warning;
    for (const std::string& reason : reasons) message += "; " + reason;
    return fail(Errc::bad_data, path_, message);
  }
  for (const std::string& reason : reasons) log_.warn(path_ + ": " + reason);
  auto scene = builder_.finish(options_.camera, options_.point_radius);
  if (!scene) return tl::unexpected(scene.error());
  if (scene->environment.kind == EnvironmentKind::classic_sky) {
    scene->environment.kind = shines(*scene) ? EnvironmentKind::none : EnvironmentKind::studio;
  }
  ImportResult result;
  result.scene = std::move(*scene);
  result.warnings = log_.take();
  result.pictures.camera_aspects = builder_.camera_aspects();
  return result;
}

}  // namespace dapple
