// Accel::locate and SurfaceBuilder for one triangle a lane, operation for operation.
#include "accel/kernels/locate-inl.h"
#include "math/real-inl.h"
#include "render/kernels/surface_chunk.h"

#if defined(DAPPLE_RENDER_SURFACE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_RENDER_SURFACE_INL_H
#undef DAPPLE_RENDER_SURFACE_INL_H
#else
#define DAPPLE_RENDER_SURFACE_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

inline constexpr float kSmallestSquare = 1e-30f;  // of a length that still has a direction

struct TrianglePointReal {
  Real3 position, outward, to_b, to_c;
  Real error, u, v;
};

HWY_INLINE Real3 in_axes(const FrameAxes& axes, const Real3& v) { return axes(v.vec()); }

HWY_INLINE TrianglePointReal locate_triangle(const LeafArrays& leaves, const Real3& ray_origin,
                                             const Real3& ray_direction, WordVec lane) {
  HitVec hit;
  hit.lane_low = lane;
  const LeafWords leaf = leaf_words(leaves, hit);
  const auto corner = [&](std::size_t i) HWY_ATTR -> Real3 {
    const FloatVec3 position = corner_of_triangles(leaf, i);
    return {position.x, position.y, position.z};
  };
  const Real3 corners[3] = {corner(0), corner(1), corner(2)};
  const FrameAxes axes = frame_axes(ray_direction.vec());
  const Real3 direction = in_axes(axes, ray_direction), origin = in_axes(axes, ray_origin);
  const Real smallest = kSmallestDirection;
  const Real inverse = Real(1.0f) / select(abs(direction.z) < smallest,
                                           hn::CopySign(smallest.v, direction.z.v), direction.z);
  const Real shear_x = direction.x * inverse, shear_y = direction.y * inverse;
  Real x[3], y[3];
  for (std::size_t i = 0; i < 3; ++i) {
    const Real3 seen = in_axes(axes, corners[i]) - origin;
    x[i] = seen.x - shear_x * seen.z;
    y[i] = seen.y - shear_y * seen.z;
  }
  const Real of_a = x[2] * y[1] - y[2] * x[1];
  const Real of_b = x[0] * y[2] - y[0] * x[2];
  const Real of_c = x[1] * y[0] - y[1] * x[0];
  const Real scale = Real(1.0f) / (of_a + of_b + of_c);
  TrianglePointReal point;
  point.u = of_b * scale;
  point.v = of_c * scale;
  point.to_b = corners[1] - corners[0];
  point.to_c = corners[2] - corners[0];
  point.position = (corners[0] + point.u * point.to_b) + point.v * point.to_c;
  const auto extent = [](const Real3& v) HWY_ATTR -> Real { return max_abs_component(v.vec()); };
  const auto over = [](Real a, Real b) HWY_ATTR -> Real { return larger(a.v, b.v); };
  const Real size = Real(1.0f) / over(extent(point.to_b), extent(point.to_c));
  const Real3 normal = cross(size * point.to_b, size * point.to_c);
  const Real squared = dot(normal, normal);
  point.outward =
      select(squared >= kSmallestNormal, normal / sqrt(squared), -normalize(ray_direction));
  point.error = Real(kTrianglePositionError) *
                over(over(extent(corners[0]), extent(corners[1])), extent(corners[2]));
  return point;
}

// The three corners' numbers and weights.
struct CornersReal {
  WordVec vertex[3];
  Real weight[3];

  // Element `index` of arrays of `stride` floats a vertex.
  HWY_INLINE Real value(const float* array, std::uint32_t stride, std::uint32_t index,
                        std::size_t corner) const {
    const WordVec at = hn::Mul(vertex[corner], all_words(stride));
    return hn::GatherIndex(Floats(), array + index, hn::BitCast(Ints(), at));
  }
  HWY_INLINE Real mixed(const float* array, std::uint32_t stride, std::uint32_t index) const {
    return weight[0] * value(array, stride, index, 0) + weight[1] * value(array, stride, index, 1) +
           weight[2] * value(array, stride, index, 2);
  }
  HWY_INLINE Real3 mixed_vectors(const float* array, std::uint32_t stride) const {
    return {mixed(array, stride, 0), mixed(array, stride, 1), mixed(array, stride, 2)};
  }
};

HWY_INLINE CornersReal corners_of(const MeshView& mesh, WordVec triangle,
                                  const TrianglePointReal& point) {
  const WordVec first = hn::Add(triangle, hn::Add(triangle, triangle));
  return {{gather(mesh.corners, first), gather(mesh.corners + 1, first),
           gather(mesh.corners + 2, first)},
          {Real(1.0f) - point.u - point.v, point.u, point.v}};
}

HWY_INLINE void store(Real v, float* floats) { hn::Store(v.v, Floats(), floats); }
HWY_INLINE void store(const Real3& v, SurfaceChunk::Vectors& arrays, std::size_t i) {
  store(v.x, arrays[0] + i);
  store(v.y, arrays[1] + i);
  store(v.z, arrays[2] + i);
}

struct TangentReal {
  Real3 wish;
  Real sign;
};

// Stores the coordinates of one set; returns along what they grow.
HWY_INLINE TangentReal add_uvs(const float* uvs, const CornersReal& corners,
                               const TrianglePointReal& point, std::size_t set, std::size_t i,
                               SurfaceChunk& chunk) {
  Real x[3], y[3];
  for (std::size_t k = 0; k < 3; ++k) {
    x[k] = corners.value(uvs, 2, 0, k);
    y[k] = corners.value(uvs, 2, 1, k);
  }
  const auto& w = corners.weight;
  store(w[0] * x[0] + w[1] * x[1] + w[2] * x[2], chunk.u[set] + i);
  store(w[0] * y[0] + w[1] * y[1] + w[2] * y[2], chunk.v[set] + i);
  const Real2 d1 = {x[1] - x[0], y[1] - y[0]}, d2 = {x[2] - x[0], y[2] - y[0]};
  const Real area = d1.x * d2.y - d1.y * d2.x;
  const Real3 normal = cross(point.to_b, point.to_c);
  const Real world_area = sqrt(dot(normal, normal));
  const Bool some = (abs(area) > 0.0f) && (world_area > 0.0f);
  const Real sign = select(area < 0.0f, -1.0f, 1.0f);
  store(where(some, sqrt(abs(area) / world_area)), chunk.uv_per_length[set] + i);
  return {where(some, sign * (d2.y * point.to_b - d1.y * point.to_c)), select(some, -sign, 1.0f)};
}

HWY_INLINE Real3 shading_normal(const MeshView& mesh, const CornersReal& corners,
                                const Real3& outward) {
  if (mesh.normals == nullptr) return outward;
  const Real3 given = corners.mixed_vectors(mesh.normals, 3);
  const Real squared = dot(given, given);
  const Real3 n = select(squared > kSmallestSquare, given / sqrt(squared), outward);
  return select(dot(n, outward) < 0.0f, -n, n);
}

HWY_INLINE void describe_lanes(const MeshView& mesh, std::size_t i, SurfaceChunk& chunk) {
  const auto vectors = [&](const SurfaceChunk::Vectors& arrays) HWY_ATTR -> Real3 {
    return {load_floats(arrays[0] + i), load_floats(arrays[1] + i), load_floats(arrays[2] + i)};
  };
  const TrianglePointReal point =
      locate_triangle(mesh.leaves, vectors(chunk.origin), vectors(chunk.direction),
                      hn::Load(Words(), chunk.lane + i));
  store(point.position, chunk.position, i);
  store(point.outward, chunk.outward, i);
  store(point.error, chunk.error + i);
  store(point.u, chunk.weight_1 + i);
  store(point.v, chunk.weight_2 + i);

  const WordVec triangle = hn::Load(Words(), chunk.triangle + i);
  hn::Store(gather(mesh.materials, triangle), Words(), chunk.material + i);
  const CornersReal corners = corners_of(mesh, triangle, point);
  const Real3 normal = shading_normal(mesh, corners, point.outward);
  store(normal, chunk.shading_normal, i);
  TangentReal tangent = {Real3{}, 1.0f};
  for (std::size_t set = kUvSetCount; set-- > 0;) {
    const float* uvs = mesh.uvs[set];
    if (uvs == nullptr) continue;
    const TangentReal along = add_uvs(uvs, corners, point, set, i, chunk);
    if (set == 0) tangent = along;
  }
  if (mesh.tangents != nullptr) {
    const Real3 given = corners.mixed_vectors(mesh.tangents, 4);
    const Bool some = dot(given, given) > kSmallestSquare;
    const Real side = select(corners.mixed(mesh.tangents, 4, 3) < 0.0f, -1.0f, 1.0f);
    tangent = {select(some, given, tangent.wish), select(some, side, tangent.sign)};
  }
  store(frame_along(normal, tangent.wish).tangent, chunk.tangent, i);
  store(tangent.sign, chunk.bitangent_sign + i);
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
