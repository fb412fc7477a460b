// Triangles of the compact form are made whole when a ray comes to them, and then tested like all
// others: so they give the same bits.
#include "accel/kernels/positions-inl.h"
#include "scene/leaf.h"

#if defined(DAPPLE_KERNELS_COMPACT_LEAF_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_COMPACT_LEAF_INL_H
#undef DAPPLE_KERNELS_COMPACT_LEAF_INL_H
#else
#define DAPPLE_KERNELS_COMPACT_LEAF_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

// A whole leaf.
struct WholeTriangles {
  LeafRow rows[leaf_rows(ShapeKind::triangle)];
};

HWY_INLINE bool has_vertex(const LeafRow* compact, std::uint32_t vertex) {
  const Words d;
  WordMask found = hn::Eq(hn::Load(d, compact->words), all_words(vertex));
  for (std::size_t i = kLanes; i < 3 * kLeafWidth; i += kLanes) {
    found = hn::Or(found, hn::Eq(hn::Load(d, compact->words + i), all_words(vertex)));
  }
  return !hn::AllFalse(d, found);
}

template <AfterLast kAfter>
HWY_NOINLINE void make_whole_with(const LeafRow* compact, const Vec3f* positions,
                                  WholeTriangles& whole) {
  const Words d;
  const auto floats = [&](std::size_t row, std::size_t i) {
    return reinterpret_cast<float*>(whole.rows[row].words + i);
  };
  for (std::size_t i = 0; i < kLeafWidth; i += kLanes) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const FloatVec3 at = load_positions<kAfter>(positions, compact[corner].words + i);
      hn::Store(at.x, Floats(), floats(3 * corner, i));
      hn::Store(at.y, Floats(), floats(3 * corner + 1, i));
      hn::Store(at.z, Floats(), floats(3 * corner + 2, i));
    }
    const WordVec ids =
        hn::Load(d, compact[leaf_id_row(ShapeKind::triangle, LeafForm::compact)].words + i);
    hn::Store(ids, d, whole.rows[leaf_id_row(ShapeKind::triangle)].words + i);
  }
}

// Lanes not in use become triangles all of whose vertices are the scene's first: nothing hits them.
HWY_INLINE void make_whole(const LeafRow* compact, const LeafArrays& leaves,
                           WholeTriangles& whole) {
  if (HWY_UNLIKELY(has_vertex(compact, leaves.last_vertex))) {
    return make_whole_with<AfterLast::nothing>(compact, leaves.positions, whole);
  }
  make_whole_with<AfterLast::a_float>(compact, leaves.positions, whole);
}

// Asks for the memory that making a leaf whole will read: triangles of a leaf mostly share
// vertices.
HWY_INLINE void prefetch_positions(const LeafRow* compact, const Vec3f* positions) {
  for (std::size_t i = 0; i < kLeafWidth; ++i) {
    __builtin_prefetch(positions + compact->words[i]);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
