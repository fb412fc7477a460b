// Traces every ray a second time, in the plain way of one ray after another, and counts.
#pragma once

#include <atomic>
#include <vector>

#include "accel/accel.h"
#include "accel/prepared_ray.h"
#include "scene/wide_bvh.h"

namespace dapple::bench {

struct VisitCounts {
  std::uint64_t rays = 0;
  std::uint64_t nodes = 0, leaves = 0, bytes = 0;
  std::uint64_t distinct_bytes = 0;  // read by at least one ray
};

// For one thread.
class VisitingAccel final : public Accel {
 public:
  // Copying the base keeps what it needs to locate hits.
  VisitingAccel(const Accel& inner, const WideBvhView& tree)
      : Accel(inner),
        inner_(inner),
        tree_(tree),
        seen_nodes_(tree.nodes.size()),
        seen_rows_(tree.rows.size()) {}

  using Accel::intersect;
  using Accel::occluded;
  void intersect(std::span<const Ray> rays, std::span<Hit> hits) const override {
    inner_.intersect(rays, hits);
    for (const Ray& ray : rays) walk(prepare(ray));
  }
  void occluded(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const override {
    inner_.occluded(rays, occluded);
  }
  AccelStats stats() const override { return inner_.stats(); }
  Bounds3f bounds() const override { return inner_.bounds(); }

  const VisitCounts& counts() const { return counts_; }

 private:
  void walk(const PreparedRay& ray) const;
  void visit_node(std::size_t index) const;
  // The distance of the nearest hit, or `best`.
  float visit_leaf(const PreparedRay& ray, LeafRef leaf, float best) const;

  const Accel& inner_;
  WideBvhView tree_;
  mutable VisitCounts counts_;
  mutable std::vector<bool> seen_nodes_, seen_rows_;
};

}  // namespace dapple::bench
