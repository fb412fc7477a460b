#include "accel/linear_accel.h"

#include <algorithm>

#include "accel/kernels/dispatch.h"
#include "scene/prims.h"

namespace dapple {
LinearAccel::LinearAccel(const SceneView& scene) : Accel(nullptr) {
  PrimId next_id = 0;
  for (std::size_t k = 0; k < kShapeKindCount; ++k) {
    const auto kind = static_cast<ShapeKind>(k);
    const std::size_t of_kind = scene.count(kind);
    for (std::size_t first = 0; first < of_kind; first += kMaxLeafCount) {
      const std::size_t count = std::min(kMaxLeafCount, of_kind - first);
      leaves_.emplace_back(kind, count, words_.size());
      words_.resize(words_.size() + count * leaf_words_per_prim(kind));
      std::uint32_t* leaf = words_.data() + leaves_.back().offset();
      for (std::size_t i = 0; i < count; ++i) {
        write_lane(scene, kind, first + i, next_id++, leaf, count, i);
      }
    }
  }
  words_.resize(words_.size() + kLeafPaddingWords);
  bounds_ = scene_bounds(scene);
  prim_count_ = next_id;
  set_leaf_words(words_.data());
}

void LinearAccel::intersect(std::span<const Ray> rays, std::span<Hit> hits) const {
  kernels().intersect_linear({leaves_, words_.data()}, rays.data(), hits.data(), rays.size());
}

void LinearAccel::occluded(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const {
  kernels().occluded_linear({leaves_, words_.data()}, rays.data(), occluded.data(), rays.size());
}

AccelStats LinearAccel::stats() const {
  AccelStats stats;
  stats.prim_count = prim_count_;
  stats.leaf_count = leaves_.size();
  stats.bytes = words_.size() * sizeof(words_[0]) + leaves_.size() * sizeof(leaves_[0]);
  return stats;
}

}  // namespace dapple
