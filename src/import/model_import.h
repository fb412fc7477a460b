// What the importers of one file with few companions share: the file itself, its folder, the scene
// under construction and the warnings.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "import/import_log.h"
#include "import/import_options.h"
#include "import/import_result.h"
#include "import/sandbox.h"
#include "import/scene_builder.h"
#include "util/mapped_file.h"

namespace dapple {

class ModelImport {
 public:
  [[nodiscard]] static Expected<ModelImport> open(const std::string& path,
                                                  const ImportOptions& options);

  const std::string& path() const { return path_; }
  const ImportOptions& options() const { return options_; }
  std::span<const std::byte> bytes() const { return file_.bytes(); }
  Sandbox& sandbox() { return sandbox_; }
  SceneBuilder& builder() { return builder_; }
  ImportLog& log() { return log_; }

  // A file beside this one; where its name leads through folders that are not there, one of the
  // same name in this one's folder.
  [[nodiscard]] Expected<MappedFile> open_companion(const std::string& name) const;
  // A picture inside this file, found by its name before any file.
  void embed(const std::string& name, RawImage picture) { embedded_[name] = std::move(picture); }
  // The content of a companion as a picture, decoded.
  [[nodiscard]] Expected<RawImage> picture(const std::string& name) const;
  // The same as a texture, stored once a name. `place` is where the file asks for it. A missing or
  // broken one is an error, or with `keep_going` a warning and magenta.
  [[nodiscard]] Expected<TextureId> texture(const std::string& name, const std::string& place,
                                            Texture settings = {});
  // The same for a picture that was put together of others.
  [[nodiscard]] Expected<TextureId> texture(const Expected<RawImage>& picture,
                                            const std::string& place, Texture settings);

  // The scene. One without a light of its own stands in the studio; one that shows nothing is an
  // error.
  [[nodiscard]] Expected<ImportResult> finish();

 private:
  ModelImport(const std::string& path, const ImportOptions& options, MappedFile file,
              Sandbox sandbox)
      : path_(path),
        options_(options),
        file_(std::move(file)),
        sandbox_(std::move(sandbox)),
        builder_(options.max_bytes) {}

  [[nodiscard]] Expected<TextureId> missing(const Error& reason, const std::string& place);
  // What was left out and why, a sentence each.
  [[nodiscard]] std::vector<std::string> left_out() const;

  std::string path_;
  ImportOptions options_;
  MappedFile file_;
  Sandbox sandbox_;
  SceneBuilder builder_;
  ImportLog log_;
  std::map<std::string, ImageId> images_;
  std::map<std::string, RawImage> embedded_;
};

}  // namespace dapple
