#include "accel/wide_accel.h"

#include "accel/kernels/dispatch.h"
#include "accel/wide_stats.h"
#include "util/float_mode.h"

namespace dapple {
namespace {

// What a second-level cache may be expected to hold beside the rays.
constexpr std::size_t kNearBytes = std::size_t{1} << 20;

}  // namespace

WideAccel::WideAccel(const SceneView& scene, BvhQuality quality, LeafForm form)
    : prim_count_(scene.object_count()) {
  WideBvhView& bvh = view_;
  bvh = scene.bvh;
  if (bvh.empty()) {
    built_ = build_wide_bvh(scene, nullptr, quality, form, TriangleParts::where_they_pay);
    bvh = built_.view();
  }
  if (!scene.instances.empty()) {
    instances_ = place_instances(scene, prototype_roots(scene, bvh.nodes));
    view_.instances = instances_;
    view_.first_id =
        static_cast<PrimId>(first_prim_ids(scene)[static_cast<std::size_t>(ShapeKind::instance)]);
  }
  std::size_t bytes = bvh.nodes.size_bytes() + bvh.rows.size_bytes();
  view_.kinds = leaf_kinds(scene);
  if (bvh.form == LeafForm::compact && view_.kinds != LeafKinds::spheres) {
    view_.kinds =
        view_.kinds == LeafKinds::triangles ? LeafKinds::compact_triangles : LeafKinds::compact_any;
    view_.positions = scene.vertices.positions;
    bytes += view_.positions.size_bytes();
  }
  view_.far = bytes > kNearBytes;
  // Prototypes that nothing shows: a ray must not start in them.
  if (prim_count_ == 0) bvh = {};
  set_leaves(view_.leaves(), instances_);
}

void WideAccel::intersect(std::span<const Ray> rays, std::span<Hit> hits) const {
  const StandardFloatMode standard;
  kernels().intersect_wide(view_, rays.data(), hits.data(), rays.size());
}

void WideAccel::occluded(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const {
  const StandardFloatMode standard;
  kernels().occluded_wide(view_, rays.data(), occluded.data(), rays.size());
}

AccelStats WideAccel::stats() const {
  AccelStats stats = wide_stats(view_);
  stats.prim_count = prim_count_;
  stats.bytes += instances_.size() * sizeof(instances_[0]);
  return stats;
}

Bounds3f WideAccel::bounds() const {
  return view_.empty() ? Bounds3f{} : node_bounds(view_.nodes.front());
}

}  // namespace dapple
