#include "accel/triangle_clipper.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dapple {
namespace {

// How much larger the box of a part is than the part, in the largest coordinate of the tree.
//
// The own-box rule (intersect_scalar.h) proves that a ray passes every box that holds the box of
// the triangle it hits, no later than the hit. The boxes above a part do not hold that box. So they
// are made larger than what rounding may do; let u = 2^-24 be that of one operation, M the largest
// coordinate, and let rays start among the shapes, so that distances along an axis are up to 2 M:
//  - The corners of a part are found with six roundings along a side and one of the sum: 13 u M.
//  - Vertices in the frame of a ray have errors of 4 u times their distance. They move the point
//  where
//    it meets the triangle by 8 u M, and along the ray by as much divided by the cosine c between
//    ray and normal.
//  - The distances to a face and to a hit have three roundings: 6 u M.
// With 2^-16 = 256 u that is enough for c above 1/28. A ray that grazes a triangle more than that,
// meets one thinner than the pad, or comes from very far, does not know the distance to it in
// single precision. Then a hit on something else may count instead, if it is nearer than the part's
// box, or none: where what is met is a matter of rounding anyway.
constexpr float kPad = 0x1p-16f;

float largest_coordinate(const Bounds3f& box) {
  float largest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    largest = std::max({largest, std::fabs(box.lo[axis]), std::fabs(box.hi[axis])});
  }
  return largest;
}

Float4 load_point(const Vec3f& p) { return Float4::of(p.x, p.y, p.z, 0); }

// A side of a triangle and where it crosses planes of one axis.
class Side {
 public:
  Side(const Vec3f& from, const Vec3f& to, int axis)
      : from_(from[axis]),
        least_(std::min(from[axis], to[axis])),
        greatest_(std::max(from[axis], to[axis])),
        start_(load_point(from)),
        way_(load_point(to) - start_) {
    const float extent = to[axis] - from[axis];
    const bool crosses = std::fabs(extent) >= std::numeric_limits<float>::min();
    inverse_ = crosses ? 1.0f / extent : 0.0f;
  }

  bool ends_before(float plane) const { return greatest_ < plane; }
  bool begins_after(float plane) const { return least_ > plane; }

  // The end that is nearer where it does not cross the plane.
  Float4 at(float plane) const {
    const float share = (std::clamp(plane, least_, greatest_) - from_) * inverse_;
    return start_ + Float4::all(share) * way_;
  }

 private:
  float from_, least_, greatest_;
  Float4 start_, way_;
  float inverse_;
};

}  // namespace

TriangleClipper::TriangleClipper(const SceneView& scene, const Bounds3f& box)
    : scene_(scene),
      first_id_(static_cast<PrimId>(
          first_prim_ids(scene)[static_cast<std::size_t>(ShapeKind::triangle)])),
      count_(static_cast<PrimId>(scene.triangles.size())),
      pad_(Float4::all(kPad * largest_coordinate(box))) {}

// Between two planes a triangle is a polygon whose corners are all on the triangle's sides: the
// ends of what is there of each side are enough for its box.
void TriangleClipper::clip(const BuildPrim& prim, int axis, std::span<const float> planes,
                           Box4* parts) const {
  const std::size_t count = planes.size() - 1;
  std::fill_n(parts, count, Box4{});
  const auto& vertices = scene_.triangles[prim.id - first_id_].vertices;
  const auto corner = [&](std::size_t i) { return scene_.vertices.positions[vertices[i % 3]]; };
  for (std::size_t i = 0; i < 3; ++i) {
    const Side side(corner(i), corner(i + 1), axis);
    std::size_t k = 0;
    while (k < count && side.begins_after(planes[k + 1])) ++k;
    Float4 end = side.at(planes[k]);
    for (; k < count && !side.ends_before(planes[k]); ++k) {
      parts[k].extend(end);
      end = side.at(planes[k + 1]);
      parts[k].extend(end);
    }
  }
  for (std::size_t k = 0; k < count; ++k) {
    parts[k].lo = parts[k].lo - pad_;
    parts[k].hi = parts[k].hi + pad_;
    if (prim.is_part == 0) continue;
    parts[k].lo = max(prim.lower(), parts[k].lo);
    parts[k].hi = min(prim.upper(), parts[k].hi);
  }
}

}  // namespace dapple
