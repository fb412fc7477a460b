#include "scene/mesh_summary.h"

namespace dapple {

MeshSummary MeshSummarizer::summarize(std::size_t first_triangle, std::size_t triangle_count) {
  MeshSummary summary{first_triangle, triangle_count, {}, {}};
  ++part_;
  for (std::size_t i = first_triangle; i < first_triangle + triangle_count; ++i) {
    for (const std::uint32_t vertex : scene_.triangles[i].vertices) {
      const Vec3f& p = scene_.vertices.positions[vertex];
      summary.box.extend({p, p});
    }
    const MaterialId material = scene_.triangle_materials[i];
    if (seen_in_[index_of(material)] == part_) continue;
    seen_in_[index_of(material)] = part_;
    summary.materials.push_back(material);
  }
  return summary;
}

}  // namespace dapple
