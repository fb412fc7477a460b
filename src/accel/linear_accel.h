// No structure at all: every ray is tested against every object. The oracle for the others.
#pragma once

#include "accel/accel.h"
#include "accel/kernels/dispatch.h"
#include "accel/leaf_list.h"

namespace dapple {

class LinearAccel final : public Accel {
 public:
  explicit LinearAccel(const SceneView& scene);

  using Accel::intersect;
  using Accel::occluded;
  void intersect(std::span<const Ray> rays, std::span<Hit> hits) const override;
  void occluded(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const override;
  AccelStats stats() const override;
  Bounds3f bounds() const override { return bounds_; }

 private:
  LeafList list_;
  std::vector<std::span<const LeafRef>> prototypes_;
  std::vector<PlacedInstance> instances_;
  LinearView view_;
  Bounds3f bounds_;
  std::size_t prim_count_;
};

}  // namespace dapple
