// Traversal of the wide BVH, one ray at a time, all children of a node at once.
#include "accel/kernels/dispatch.h"
#include "accel/kernels/leaf-inl.h"

#if defined(DAPPLE_KERNELS_WIDE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_WIDE_INL_H
#undef DAPPLE_KERNELS_WIDE_INL_H
#else
#define DAPPLE_KERNELS_WIDE_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

// A child still to be visited, and where the ray enters its box.
struct Pending {
  float near;
  ChildRef child;
};

// Every level of the tree leaves at most all children but one behind.
inline constexpr std::size_t kStackSize = kMaxWideDepth * (kWideWidth - 1) + 1;

// Which planes of a node's boxes a ray meets first depends on the signs of its direction.
struct NodePlanes {
  std::size_t near[3], far[3];  // float offsets in a node

  HWY_INLINE explicit NodePlanes(const PreparedRay& ray) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool up = ray.inverse[axis] >= 0.0f;
      near[axis] = (axis + (up ? 0 : 3)) * kWideWidth;
      far[axis] = (axis + (up ? 3 : 0)) * kWideWidth;
    }
  }
};

// Enters the boxes of a node; bit i is set if the ray passes child i no later than t_best.
HWY_INLINE std::uint32_t enter_children(const PreparedRay& ray, const NodePlanes& planes,
                                        const WideNode& node, float t_best, float* near) {
  const float* floats = &node.lo[0][0];
  const FloatVec t_min = all(ray.t_min), t_max = all(t_best);
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < kWideWidth; i += kLanes) {
    const FloatVec nx = meet(load_floats(floats + planes.near[0] + i), ray, 0);
    const FloatVec ny = meet(load_floats(floats + planes.near[1] + i), ray, 1);
    const FloatVec nz = meet(load_floats(floats + planes.near[2] + i), ray, 2);
    const FloatVec fx = meet(load_floats(floats + planes.far[0] + i), ray, 0);
    const FloatVec fy = meet(load_floats(floats + planes.far[1] + i), ray, 1);
    const FloatVec fz = meet(load_floats(floats + planes.far[2] + i), ray, 2);
    const FloatVec entry = hn::Max(hn::Max(nx, ny), hn::Max(nz, t_min));
    const FloatVec exit = hn::Min(hn::Min(fx, fy), hn::Min(fz, t_max));
    hn::Store(entry, Floats(), near + i);
    bits |= bits_of(hn::Le(entry, exit)) << i;
  }
  return bits;
}

// Puts the children in `bits` on the stack, the nearest on top.
HWY_INLINE Pending* push_sorted(const WideNode& node, std::uint32_t bits, const float* near,
                                Pending* top) {
  Pending* const bottom = top;
  while (bits != 0) {
    const std::uint32_t i = take_lowest(bits);
    const Pending pending{near[i], node.children[i]};
    Pending* place = top++;
    for (; place != bottom && place[-1].near < pending.near; --place) *place = place[-1];
    *place = pending;
  }
  return top;
}

HWY_INLINE Hit intersect_one(const WideBvhView& bvh, const Ray& input) {
  const PreparedRay ray = prepare(input);
  const NodePlanes planes(ray);
  Hit best = nothing_before(ray.t_max);
  Pending stack[kStackSize];
  Pending* top = stack;
  *top++ = {ray.t_min, ChildRef::node(0)};
  alignas(64) float near[kWideWidth];
  while (top != stack) {
    const Pending next = *--top;
    if (next.near > best.t) continue;
    if (next.child.is_leaf()) {
      intersect_leaf(ray, next.child.leaf(), bvh.leaf_words.data(), best);
      continue;
    }
    const WideNode& node = bvh.nodes[next.child.node_index()];
    const std::uint32_t bits = enter_children(ray, planes, node, best.t, near);
    top = push_sorted(node, bits, near, top);
  }
  return finished(best);
}

HWY_INLINE bool occluded_one(const WideBvhView& bvh, const Ray& input) {
  const PreparedRay ray = prepare(input);
  const NodePlanes planes(ray);
  ChildRef stack[kStackSize];
  ChildRef* top = stack;
  *top++ = ChildRef::node(0);
  alignas(64) float near[kWideWidth];
  while (top != stack) {
    const ChildRef next = *--top;
    if (next.is_leaf()) {
      if (leaf_occludes(ray, next.leaf(), bvh.leaf_words.data())) return true;
      continue;
    }
    const WideNode& node = bvh.nodes[next.node_index()];
    std::uint32_t bits = enter_children(ray, planes, node, ray.t_max, near);
    while (bits != 0) *top++ = node.children[take_lowest(bits)];
  }
  return false;
}

HWY_ATTR void intersect_wide(const WideBvhView& bvh, const Ray* rays, Hit* hits,
                             std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    hits[i] = bvh.nodes.empty() ? Hit{} : intersect_one(bvh, rays[i]);
  }
}

HWY_ATTR void occluded_wide(const WideBvhView& bvh, const Ray* rays, std::uint8_t* occluded,
                            std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    occluded[i] = !bvh.nodes.empty() && occluded_one(bvh, rays[i]) ? 1 : 0;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
