#include "scene_file/mapped_scene.h"

#include <utility>

namespace dapple {

Expected<MappedScene> MappedScene::open(const std::string& path, const VerifyOptions& options) {
  auto file = options.copy ? MappedFile::open_copy(path) : MappedFile::open(path);
  if (!file) return tl::unexpected(file.error());
  auto scene = verify(file->bytes(), options);
  if (!scene) {
    Error error = scene.error();
    error.place = path;
    return tl::unexpected(error);
  }
  return MappedScene(std::move(*file), std::move(*scene));
}

}  // namespace dapple
