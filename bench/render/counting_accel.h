// Counts the rays that go through another structure.
#pragma once

#include <atomic>
#include <memory>

#include "accel/accel.h"

namespace dapple::bench {

class CountingAccel final : public Accel {
 public:
  // Copying the base keeps what it needs to locate hits.
  explicit CountingAccel(const Accel& inner) : Accel(inner), inner_(inner) {}

  using Accel::intersect;
  using Accel::occluded;
  void intersect(std::span<const Ray> rays, std::span<Hit> hits) const override {
    count_ += rays.size();
    inner_.intersect(rays, hits);
  }
  void occluded(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const override {
    count_ += rays.size();
    inner_.occluded(rays, occluded);
  }
  AccelStats stats() const override { return inner_.stats(); }
  Bounds3f bounds() const override { return inner_.bounds(); }

  std::uint64_t count() const { return count_; }

 private:
  const Accel& inner_;
  mutable std::atomic<std::uint64_t> count_{0};
};

}  // namespace dapple::bench
