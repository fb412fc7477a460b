// From where and in which surroundings a scene is to be seen, where that differs from what it says.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/framing.h"
#include "scene/scene_view.h"
#include "util/error.h"
#include "util/huge_array.h"

namespace dapple {

struct ViewOptions {
  std::string camera;  // name or index of one of the scene's; empty: the one in use
  std::optional<Orbit> orbit;
  std::optional<Vec3d> target;     // of the orbit; without: the middle of the scene
  std::optional<double> fov;       // vertical, degrees
  bool frame = false;              // a camera that sees the whole scene, whatever the scene's own
  std::string environment;         // an image file, "studio" or "none"; empty: the scene's own
  std::optional<double> rotation;  // of the environment about +y, degrees
};

// The number of the camera of that name, or whose number it is.
[[nodiscard]] Expected<std::size_t> camera_index(std::span<const NamedCamera> cameras,
                                                 const std::string& name_or_number);

// A view with other camera and surroundings; owns what it adds. The scene's arrays must outlive it.
class EditedView {
 public:
  [[nodiscard]] static Expected<EditedView> create(const SceneView& scene,
                                                   const ViewOptions& options,
                                                   double width_over_height);

  const SceneView& view() const { return view_; }

 private:
  Status choose_camera(const ViewOptions& options, double width_over_height);
  Status choose_environment(const ViewOptions& options);
  Status load_environment(const std::string& path);

  SceneView view_;
  std::vector<TextureImage> images_;
  HugeArray<std::uint8_t> texels_;
};

}  // namespace dapple
