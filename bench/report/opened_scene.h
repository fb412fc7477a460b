// A scene with what rendering it takes.
#pragma once

#include <memory>
#include <string>

#include "render/render_job.h"
#include "scene_file/scene_source.h"

namespace dapple::bench {

class OpenedScene {
 public:
  static Expected<OpenedScene> open(const std::string& name) {
    auto source = SceneSource::open(name);
    if (!source) return tl::unexpected(source.error());
    return OpenedScene(std::make_unique<SceneSource>(std::move(*source)));
  }

  const SceneView& view() const { return source_->view(); }
  std::unique_ptr<PreparedScene> prepare(AccelKind kind) const {
    return std::make_unique<PreparedScene>(view(), make_accel(kind, view()));
  }

 private:
  explicit OpenedScene(std::unique_ptr<SceneSource> source) : source_(std::move(source)) {}

  std::unique_ptr<SceneSource> source_;
};

inline RenderSettings picture(int width, int height, int samples) {
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  settings.samples_per_pixel = samples;
  return settings;
}

}  // namespace dapple::bench
