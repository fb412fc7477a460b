// The one interface to every way of finding what a ray hits.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string_view>

#include "accel/bvh_quality.h"
#include "accel/hit.h"
#include "accel/placed_instance.h"
#include "math/bounds3.h"
#include "math/ray.h"
#include "scene/scene_view.h"
#include "util/error.h"

namespace dapple {

enum class AccelKind {
  linear,  // no structure: every ray is tested against every object
  median,  // the textbook binary BVH: median split, one object a leaf
  fast,    // wide BVH built by binned SAH, traversed with SIMD
};

struct AccelStats {
  std::size_t prim_count = 0;
  std::size_t node_count = 0;
  std::size_t leaf_count = 0;
  std::size_t bytes = 0;  // nodes and leaves, without the scene
  double sah_cost = 0;    // expected node and leaf visits of a ray through the root; 0 if no tree
  int depth = 0;          // levels of nodes
};

// The place on a surface that a hit denotes.
struct SurfacePoint {
  Vec3f position;  // on the surface to within `error`
  // Unit normal: away from a sphere's centre, along a rectangle's third axis, to the side from
  // which a triangle's vertices run counter-clockwise.
  Vec3f outward;
  float error = 0;     // bound on the distance between `position` and the exact surface
  float u = 0, v = 0;  // weights of a triangle's second and third vertex; the first has the rest
};

// A few units in the last place of the largest coordinate that went into a position.
inline constexpr float kPositionError = 0x1p-21f;
inline constexpr float kTrianglePositionError = 0x1p-20f;
// Squares below this have lost digits.
inline constexpr float kSmallestNormal = std::numeric_limits<float>::min();

// Immutable after construction; every call may be made from many threads at once. All kinds give
// the same hits bit for bit. A hit is the nearest in [t_min, t_max]; among equals the lowest id.
class Accel {
 public:
  virtual ~Accel() = default;

  // hits[i] is what rays[i] hits; the spans have the same length.
  virtual void intersect(std::span<const Ray> rays, std::span<Hit> hits) const = 0;
  // occluded[i] is 1 if rays[i] hits anything, else 0.
  virtual void occluded(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const = 0;

  virtual AccelStats stats() const = 0;
  virtual Bounds3f bounds() const = 0;  // a little more where triangles are split

  Hit intersect(const Ray& ray) const;
  bool occluded(const Ray& ray) const;

  // Where the lanes of hits point into, and what those are seen through.
  const LeafArrays& leaves() const { return leaves_; }
  const PlacedInstance* instances() const { return instances_; }
  // `hit` must have been found by this structure for this ray.
  SurfacePoint locate(const Ray& ray, const Hit& hit) const;

 protected:
  // To be called before any ray is traced: where hits point into.
  void set_leaves(const LeafArrays& leaves, std::span<const PlacedInstance> instances) {
    leaves_ = leaves;
    instances_ = instances.data();
  }

 private:
  LeafArrays leaves_;
  const PlacedInstance* instances_ = nullptr;
};

// Names as on the command line; an unknown one is an error that lists them.
[[nodiscard]] Expected<AccelKind> parse_accel_kind(std::string_view name);
[[nodiscard]] std::string_view accel_name(AccelKind kind);

[[nodiscard]] Expected<BvhQuality> parse_bvh_quality(std::string_view name);
[[nodiscard]] std::string_view bvh_quality_name(BvhQuality quality);

// The scene must be valid (scene/validate.h); it is not needed afterwards, but for the positions of
// its vertices if the form is compact. Quality and form are those of the fast structure, if the
// scene does not bring its own.
[[nodiscard]] std::unique_ptr<Accel> make_accel(AccelKind kind, const SceneView& scene,
                                                BvhQuality quality = BvhQuality::medium,
                                                LeafForm form = LeafForm::whole);

}  // namespace dapple
