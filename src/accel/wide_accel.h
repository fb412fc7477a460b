// The fast way: the wide BVH, built here or taken from a scene file as it stands.
#pragma once

#include "accel/accel.h"
#include "accel/kernels/dispatch.h"
#include "accel/wide_builder.h"

namespace dapple {

class WideAccel final : public Accel {
 public:
  // Uses the scene's finished BVH when it has one, which must then outlive this; else builds.
  // One with compact leaves reads the positions of the scene's vertices, which must outlive it too.
  explicit WideAccel(const SceneView& scene, BvhQuality quality = BvhQuality::medium,
                     LeafForm form = LeafForm::whole);

  using Accel::intersect;
  using Accel::occluded;
  void intersect(std::span<const Ray> rays, std::span<Hit> hits) const override;
  void occluded(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const override;
  AccelStats stats() const override;
  Bounds3f bounds() const override;

  const WideView& view() const { return view_; }

 private:
  WideBvh built_;
  std::vector<PlacedInstance> instances_;
  WideView view_;
  std::size_t prim_count_;
};

}  // namespace dapple
