// A packet in a leaf of whatever kind.
#include "accel/kernels/packet_spheres-inl.h"
#include "accel/kernels/packet_triangles-inl.h"

#if defined(DAPPLE_KERNELS_PACKET_LEAF_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_PACKET_LEAF_INL_H
#undef DAPPLE_KERNELS_PACKET_LEAF_INL_H
#else
#define DAPPLE_KERNELS_PACKET_LEAF_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

struct OneRectangle {
  float numbers[5];
};

HWY_INLINE OneRectangle take_rectangle(const LeafRow* leaf, std::size_t lane) {
  OneRectangle rectangle;
  for (std::size_t row = 0; row < 5; ++row) {
    rectangle.numbers[row] = load_float(leaf[row].words + lane);
  }
  return rectangle;
}

template <class Packet>
HWY_INLINE LaneHits meet_rectangle(const Packet& packet, std::size_t i, RectangleAxes axes,
                                   const PacketBounds& bounds, const float* numbers) {
  const auto cross = [&](float plane, int axis) {
    return hn::Mul(hn::Sub(all(plane), load_floats(packet.origin[axis] + i)),
                   load_floats(packet.inverse[axis] + i));
  };
  const bool u_up = bounds.up[axes.u], v_up = bounds.up[axes.v];
  const FloatVec t = cross(numbers[4], axes.k);
  const FloatVec near =
      hn::Max(hn::Max(cross(numbers[u_up ? 0 : 1], axes.u), cross(numbers[v_up ? 2 : 3], axes.v)),
              load_floats(packet.t_min + i));
  const FloatVec far =
      hn::Min(hn::Min(cross(numbers[u_up ? 1 : 0], axes.u), cross(numbers[v_up ? 3 : 2], axes.v)),
              load_floats(packet.best_t + i));
  const FloatVec steep = hn::Abs(load_floats(packet.direction[axes.k] + i));
  const FloatMask crosses = hn::Ge(steep, all(kSmallestDirection));
  return {hn::And(crosses, hn::And(hn::Ge(t, near), hn::Le(t, far))), t};
}

template <bool kAnyHit, class Packet>
HWY_INLINE int visit_rectangles(const PacketBounds& bounds, ChildRef ref, const LeafRow* leaf,
                                Packet& packet) {
  const ShapeKind kind = ref.leaf_kind();
  return meet_candidates<kAnyHit>(
      0xffffu, ref, leaf[leaf_id_row(kind)].words, packet, [&](std::uint32_t lane) HWY_ATTR {
        return [&packet, &bounds, rectangle = take_rectangle(leaf, lane),
                kind](std::size_t i) HWY_ATTR {
          return meet_rectangle(packet, i, rectangle_axes(kind), bounds, rectangle.numbers);
        };
      });
}

// Returns the work done.
template <LeafKinds kKinds, bool kAnyHit, class Packet>
HWY_INLINE int visit_leaf(const PacketBounds& bounds, ChildRef ref, const LeafArrays& leaves,
                          Packet& packet) {
  const LeafRow* leaf = leaves.rows + ref.leaf_row();
  const ShapeKind kind = kKinds == LeafKinds::spheres     ? ShapeKind::sphere
                         : kKinds == LeafKinds::triangles ? ShapeKind::triangle
                                                          : ref.leaf_kind();
  if (kind == ShapeKind::sphere) return visit_spheres<kAnyHit>(bounds, ref, leaf, packet);
  if (kind != ShapeKind::triangle) return visit_rectangles<kAnyHit>(bounds, ref, leaf, packet);
  WholeTriangles room;
  if (kKinds == LeafKinds::any && leaves.positions != nullptr) {
    make_whole(leaf, leaves, room);
    leaf = room.rows;
  }
  return visit_triangles<kAnyHit>(bounds, ref, leaf, packet);
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
