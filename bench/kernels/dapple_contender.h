// dapple's own structures, through the interface that the renderer uses.
#pragma once

#include "accel/accel.h"
#include "kernels/tracer.h"

namespace dapple::bench {

class DappleContender final : public Contender {
 public:
  DappleContender(AccelKind kind, BvhQuality quality, LeafForm form)
      : kind_(kind), quality_(quality), form_(form) {}

  std::string name() const override { return "dapple"; }
  void build(const SceneView& scene) override {
    accel_ = make_accel(kind_, scene, quality_, form_);
  }
  void discard() override { accel_.reset(); }
  std::size_t bytes() const override { return accel_->stats().bytes; }
  double sah_cost() const override { return accel_->stats().sah_cost; }
  std::vector<std::unique_ptr<Tracer>> tracers(std::span<const Ray> rays,
                                               Query query) const override;

 private:
  AccelKind kind_;
  BvhQuality quality_;
  LeafForm form_;
  std::unique_ptr<Accel> accel_;
};

}  // namespace dapple::bench
