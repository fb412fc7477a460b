// The definition of a hit (accel/intersect_scalar.h), applied to every object in turn, without
// any structure or SIMD: what every way of finding hits must return bit for bit.
#pragma once

#include <vector>

#include "accel/hit.h"
#include "accel/intersect_scalar.h"
#include "scene/prims.h"

namespace dapple::test {

class ScalarOracle {
 public:
  explicit ScalarOracle(const SceneView& scene) {
    PrimId id = 0;
    for (std::size_t k = 0; k < kShapeKindCount; ++k) {
      const auto kind = static_cast<ShapeKind>(k);
      for (std::size_t i = 0; i < scene.count(kind); ++i) {
        lanes_.emplace_back(kind, 1, words_.size());
        words_.resize(words_.size() + leaf_words_per_prim(kind));
        write_lane(scene, kind, i, id++, words_.data() + lanes_.back().offset(), 1, 0);
      }
    }
  }

  Hit intersect(const Ray& input) const {
    const PreparedRay ray = prepare(input);
    Hit best;
    best.t = ray.t_max;
    for (PrimId id = 0; id < lanes_.size(); ++id) {
      const float t = intersect_lane(ray, words_.data(), lanes_[id], best.t);
      // In ascending order of ids an equal distance never replaces the first.
      if (t >= 0 && (t < best.t || !best.found())) best = {t, id, lanes_[id]};
    }
    return best.found() ? best : Hit{};
  }

 private:
  std::vector<LeafRef> lanes_;
  std::vector<std::uint32_t> words_;
};

}  // namespace dapple::test
