#include "kernels/embree_contender.h"

#include <fmt/format.h>

#include "accel/kernels/dispatch.h"
#include "kernels/embree_geometry.h"
#include "kernels/embree_tracers.h"
#include "parallel/parallel.h"

namespace dapple::bench {
namespace {

// Where dapple is held to an instruction set, Embree is held to the same.
std::string_view isa_setting() {
  const std::string_view isa = kernels().isa;
  if (isa == "avx2") return ",isa=avx2";
  return isa == "sse4" ? ",isa=sse4.2" : "";
}

}  // namespace

bool EmbreeContender::count_bytes(void* self, ssize_t bytes, bool) {
  static_cast<EmbreeContender*>(self)->bytes_ += bytes;
  return true;
}

// The affinity of its threads is left to us; a device of one thread builds on the calling one.
void EmbreeContender::build(const SceneView& scene) {
  discard();
  device_ = rtcNewDevice(
      fmt::format("threads={},set_affinity=0{}", thread_count(), isa_setting()).c_str());
  rtcSetDeviceMemoryMonitorFunction(device_, count_bytes, this);
  scene_ = rtcNewScene(device_);
  rtcSetSceneBuildQuality(scene_, quality_);
  if (compact_) rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_COMPACT);
  attach_spheres(device_, scene_, scene, quality_);
  attach_rectangles(device_, scene_, scene, quality_);
  attach_triangles(device_, scene_, scene, quality_);
  rtcCommitScene(scene_);
  const auto ids = first_prim_ids(scene);
  const auto first = [&](ShapeKind kind) {
    return static_cast<PrimId>(ids[static_cast<std::size_t>(kind)]);
  };
  first_ids_[kQuadGeometry] = first(ShapeKind::xy_rectangle);
  first_ids_[kTriangleGeometry] = first(ShapeKind::triangle);
}

void EmbreeContender::discard() {
  if (device_ == nullptr) return;
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
  device_ = nullptr;
  scene_ = nullptr;
  bytes_ = 0;
}

std::size_t EmbreeContender::bytes() const { return static_cast<std::size_t>(bytes_.load()); }

std::vector<std::unique_ptr<Tracer>> EmbreeContender::tracers(std::span<const Ray> rays,
                                                              Query query) const {
  return make_embree_tracers(scene_, rays, query, first_ids_);
}

}  // namespace dapple::bench
