#include "scene/footprint.h"

#include <array>

#include "scene/scene_arrays.h"

namespace dapple {
namespace {

using BytesOfKinds = std::array<double, kShapeKindCount>;

BytesOfKinds bvh_bytes(const WideBvhView& bvh) {
  std::array<std::size_t, kShapeKindCount> leaves{};
  std::size_t leaf_count = 0;
  for (const WideNode& node : bvh.nodes) {
    for (const ChildRef child : node.children) {
      if (!child.is_leaf()) continue;
      ++leaves[static_cast<std::size_t>(child.leaf_kind())];
      ++leaf_count;
    }
  }
  BytesOfKinds bytes{};
  if (leaf_count == 0) return bytes;
  const double per_leaf =
      static_cast<double>(bvh.nodes.size_bytes()) / static_cast<double>(leaf_count);
  for (std::size_t k = 0; k < kShapeKindCount; ++k) {
    const auto rows =
        static_cast<double>(leaf_rows(static_cast<ShapeKind>(k), bvh.form) * sizeof(LeafRow));
    bytes[k] = static_cast<double>(leaves[k]) * (rows + per_leaf);
  }
  return bytes;
}

std::size_t vertex_bytes(const VertexView& v) {
  std::size_t bytes = v.positions.size_bytes() + v.normals.size_bytes() + v.tangents.size_bytes() +
                      v.colours.size_bytes();
  for (const auto& set : v.uvs) bytes += set.size_bytes();
  return bytes;
}

}  // namespace

Footprint footprint_of(const SceneView& scene) {
  const BytesOfKinds in_bvh = bvh_bytes(scene.bvh);
  const auto each = [&](ShapeKind kind, std::size_t array_bytes) {
    const std::size_t count = scene.count(kind);
    const double bytes = static_cast<double>(array_bytes) + in_bvh[static_cast<std::size_t>(kind)];
    return count == 0 ? 0.0 : bytes / static_cast<double>(count);
  };
  Footprint footprint;
  footprint.per_triangle =
      each(ShapeKind::triangle, vertex_bytes(scene.vertices) + scene.triangles.size_bytes() +
                                    scene.triangle_materials.size_bytes());
  footprint.per_instance = each(ShapeKind::instance, scene.instances.size_bytes());
  footprint.total = scene.bvh.nodes.size_bytes() + scene.bvh.rows.size_bytes() +
                    scene.materials.size_bytes() + scene.runs.size_bytes();
  for_each_array(
      [&](SceneArray, const auto& elements) { footprint.total += elements.size_bytes(); }, scene);
  return footprint;
}

}  // namespace dapple
