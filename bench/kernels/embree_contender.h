// Embree 3 over the same shapes: spheres as its sphere geometry, rectangles as its quads.
#pragma once

#include <embree3/rtcore.h>

#include <atomic>

#include "kernels/embree_geometry.h"
#include "kernels/tracer.h"

namespace dapple::bench {

class EmbreeContender final : public Contender {
 public:
  EmbreeContender(RTCBuildQuality quality, bool compact) : quality_(quality), compact_(compact) {}
  ~EmbreeContender() override { discard(); }
  EmbreeContender(const EmbreeContender&) = delete;
  EmbreeContender& operator=(const EmbreeContender&) = delete;

  std::string name() const override { return "Embree"; }
  void build(const SceneView& scene) override;
  void discard() override;
  std::size_t bytes() const override;
  double sah_cost() const override { return 0; }
  std::vector<std::unique_ptr<Tracer>> tracers(std::span<const Ray> rays,
                                               Query query) const override;

 private:
  static bool count_bytes(void* self, ssize_t bytes, bool post);

  RTCBuildQuality quality_;
  bool compact_;
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
  FirstIds first_ids_{};
  std::atomic<std::int64_t> bytes_{0};  // what the device has allocated
};

}  // namespace dapple::bench
