// What builders sort: a primitive's box and its id.
#pragma once

#include "math/bounds3.h"
#include "math/float4.h"
#include "scene/prims.h"
#include "util/huge_array.h"

namespace dapple {

// Two vectors of four; the fourth lanes are not part of the box. As a float an id is mostly a
// denormal number, slow to calculate with, so sums leave it out.
struct alignas(16) BuildPrim {
  float lo[3];
  PrimId id;
  float hi[3];
  float is_part;  // 0, or 1 where the box is around a part of the shape only

  Float4 lower() const { return Float4::load(lo); }
  Float4 upper() const { return Float4::load(hi); }
  // Twice the centre of the box: what primitives are sorted by.
  Float4 twice_centre() const { return lower().xyz() + upper(); }
};
static_assert(sizeof(BuildPrim) == 32);

// A box in two vectors.
struct Box4 {
  Float4 lo = Float4::all(Bounds3f::kInfinity);
  Float4 hi = Float4::all(-Bounds3f::kInfinity);

  void extend(const Box4& other) {
    lo = min(lo, other.lo);
    hi = max(hi, other.hi);
  }
  void extend(const BuildPrim& prim) {
    lo = min(lo, prim.lower());
    hi = max(hi, prim.upper());
  }
  void extend(Float4 point) {
    lo = min(lo, point);
    hi = max(hi, point);
  }
  Bounds3f bounds() const;
  float half_area() const { return bounds().half_area(); }
};

inline Bounds3f Box4::bounds() const {
  float l[4], h[4];
  lo.store(l);
  hi.store(h);
  return {{l[0], l[1], l[2]}, {h[0], h[1], h[2]}};
}

// The boxes of what stands in the world, or of the triangles of one prototype, in the order of ids.
// In parallel.
[[nodiscard]] HugeArray<BuildPrim> make_build_prims(const SceneView& scene,
                                                    const PrototypeBoxes& prototypes);
[[nodiscard]] HugeArray<BuildPrim> make_prototype_prims(const SceneView& scene,
                                                        const Prototype& prototype);

}  // namespace dapple
