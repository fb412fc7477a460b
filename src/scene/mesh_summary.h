// What can be said of many triangles in a line or two.
#pragma once

#include <cstdint>
#include <vector>

#include "math/bounds3.h"
#include "scene/scene_view.h"

namespace dapple {

struct MeshSummary {
  std::size_t first_triangle = 0;
  std::size_t triangle_count = 0;
  Bounds3f box;                       // of their vertices
  std::vector<MaterialId> materials;  // each once, in the order in which they first occur
};

// Summaries of parts of a valid scene, in time proportional to the triangles in them.
class MeshSummarizer {
 public:
  explicit MeshSummarizer(const SceneView& scene)
      : scene_(scene), seen_in_(scene.materials.size(), 0) {}

  [[nodiscard]] MeshSummary summarize(std::size_t first_triangle, std::size_t triangle_count);

 private:
  const SceneView& scene_;
  std::vector<std::uint32_t> seen_in_;  // the last part in which each material occurred
  std::uint32_t part_ = 0;
};

}  // namespace dapple
