// The rays of a stream in a leaf of spheres.
//
// First a cheap test of all rays with all spheres, which may say yes too often but never no where
// there is a hit; then the exact one for the pairs that are left.
#include "accel/kernels/meet_sphere-inl.h"
#include "accel/kernels/stream_rays-inl.h"

#if defined(DAPPLE_KERNELS_STREAM_SPHERES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_STREAM_SPHERES_INL_H
#undef DAPPLE_KERNELS_STREAM_SPHERES_INL_H
#else
#define DAPPLE_KERNELS_STREAM_SPHERES_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

// With c the centre seen from that of the leaf's first sphere: -2 c and r^2 - c^2. The squares are
// enlarged by many times what rounding can do to them or to the exact test.
inline constexpr float kSquaresMargin = 0x1p-18f;

struct alignas(64) CoarseSpheres {
  float first[3];  // the centre of the first
  float c[3][kLeafWidth], reach[kLeafWidth];
  FloatVec largest_square;  // of a radius
  std::uint32_t count = 0;
};

HWY_INLINE CoarseSpheres coarsen(const LeafRow* leaf) {
  const Floats d;
  CoarseSpheres spheres;
  FloatVec largest = hn::Zero(d);
  for (std::size_t axis = 0; axis < 3; ++axis) spheres.first[axis] = load_float(leaf[axis].words);
  for (std::size_t i = 0; i < kLeafWidth; i += kLanes) {
    const FloatVec radius = load_row(leaf, 3, i);
    FloatVec squared = hn::Zero(d);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const FloatVec c = hn::Sub(load_row(leaf, axis, i), all(spheres.first[axis]));
      squared = hn::MulAdd(c, c, squared);
      hn::Store(hn::Mul(all(-2.0f), c), d, spheres.c[axis] + i);
    }
    const FloatVec radius_squared = hn::Mul(radius, radius);
    largest = hn::Max(largest, radius_squared);
    const FloatVec margin = hn::Mul(all(kSquaresMargin), hn::Add(radius_squared, squared));
    hn::Store(hn::Add(hn::Sub(radius_squared, squared), margin), d, spheres.reach + i);
    const WordVec ids = hn::Load(Words(), leaf[leaf_id_row(ShapeKind::sphere)].words + i);
    spheres.count +=
        static_cast<std::uint32_t>(hn::CountTrue(Words(), hn::Ne(ids, all_words(kNoPrim))));
  }
  spheres.largest_square = hn::MaxOfLanes(d, largest);
  return spheres;
}

// Where the exact test might overflow, it takes even what lies behind for hit at infinity.
inline constexpr float kLargestChord = 0x1p120f;

// Rays from where their interval begins, seen from the leaf's first sphere: o + t d.
struct CoarseRays {
  FloatVec o[3], half[3];  // -d / 2
  FloatVec o_dot_d;        // negative
  FloatVec squared;        // o^2; not a number where the coarse test may not say no
  FloatVec inverse_dot;
};

HWY_INLINE CoarseRays coarsen(const Quads& origin, const Quads& direction,
                              const CoarseSpheres& spheres) {
  CoarseRays rays;
  FloatVec along = hn::Zero(Floats()), squared = along;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const FloatVec d = direction.of[axis];
    rays.o[axis] = hn::MulAdd(origin.of[3], d, hn::Sub(origin.of[axis], all(spheres.first[axis])));
    rays.half[axis] = hn::Mul(all(-0.5f), d);
    along = hn::MulAdd(rays.o[axis], d, along);
    squared = hn::MulAdd(rays.o[axis], rays.o[axis], squared);
  }
  rays.o_dot_d = hn::Neg(along);
  rays.inverse_dot = direction.of[3];
  const FloatMask safe =
      hn::Lt(hn::Mul(spheres.largest_square, rays.inverse_dot), all(kLargestChord));
  rays.squared =
      hn::IfThenElse(safe, hn::Mul(squared, all(1.0f - kSquaresMargin)), hn::NaN(Floats()));
  return rays;
}

// Whether the ray begins inside of the sphere, or goes towards it and passes it: with f = c - o,
// whether max(f d, 0)^2 / d^2 >= f^2 - r^2. Also where that overflows.
HWY_INLINE FloatMask may_meet(const CoarseRays& rays, const CoarseSpheres& spheres, std::size_t k) {
  const FloatVec x = all(spheres.c[0][k]), y = all(spheres.c[1][k]), z = all(spheres.c[2][k]);
  const FloatVec towards = hn::MulAdd(
      x, rays.half[0], hn::MulAdd(y, rays.half[1], hn::MulAdd(z, rays.half[2], rays.o_dot_d)));
  const FloatVec ahead = hn::Max(towards, hn::Zero(Floats()));
  const FloatVec apart =
      hn::MulAdd(x, rays.o[0], hn::MulAdd(y, rays.o[1], hn::MulAdd(z, rays.o[2], rays.squared)));
  const FloatVec reach = hn::MulAdd(hn::Mul(ahead, rays.inverse_dot), ahead, all(spheres.reach[k]));
  return hn::Not(hn::Gt(apart, reach));
}

// Lists the pairs of the leaf's spheres with listed rays, at most kLeafPiece: numbers of rays, and
// above them lanes.
HWY_INLINE std::size_t list_pairs(const CoarseSpheres& spheres, const RayList& list,
                                  StreamScratch& s) {
  RayList pairs = {s.pairs};
  for (std::size_t i = 0; i < list.count; i += kLanes) {
    CoarseRays rays = coarsen(load_quads(s.origin, list.rays + i),
                              load_quads(s.direction, list.rays + i), spheres);
    rays.squared = hn::IfThenElse(list.there(i), rays.squared, all(Bounds3f::kInfinity));
    WordVec listed = hn::LoadU(Words(), list.rays + i);
    for (std::size_t k = 0; k < spheres.count; ++k) {
      pairs.append(listed, may_meet(rays, spheres, k));
      listed = hn::Add(listed, all_words(1u << kNumberBits));
    }
  }
  pairs.pad();
  return pairs.count;
}

// row[lane] for each lane.
HWY_INLINE FloatVec choose(const LeafRow& row, WordVec lane) {
#if HWY_TARGET <= HWY_AVX3
  return hn::TableLookupLanes(hn::Load(Floats(), reinterpret_cast<const float*>(row.words)),
                              hn::IndicesFromVec(Floats(), lane));
#else
  return floats_of_bits(gather(row.words, lane));
#endif
}

HWY_INLINE SphereLanes choose_spheres(const LeafRow* leaf, WordVec lane) {
  SphereLanes spheres;
  spheres.radius = choose(leaf[3], lane);
  const FloatVec size = hn::Abs(spheres.radius);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    spheres.c[axis] = choose(leaf[axis], lane);
    spheres.lo[axis] = hn::Sub(spheres.c[axis], size);
    spheres.hi[axis] = hn::Add(spheres.c[axis], size);
  }
  return spheres;
}

HWY_INLINE RayLanes listed_rays(const StreamScratch& s, const std::uint32_t* listed) {
  const Quads origin = load_quads(s.origin, listed), inverse = load_quads(s.inverse, listed);
  const Quads direction = load_quads(s.direction, listed);
  RayLanes rays;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rays.origin[axis] = origin.of[axis];
    rays.inverse[axis] = inverse.of[axis];
    rays.direction[axis] = direction.of[axis];
  }
  rays.t_min = origin.of[3];
  rays.t_max = inverse.of[3];
  rays.inverse_dot = direction.of[3];
  return rays;
}

// Of the pairs those that meet, and where.
HWY_INLINE std::size_t meet_pairs(const LeafRow* leaf, std::size_t count, StreamScratch& s) {
  const Words w;
  RayList found = {s.found}, distances = {s.found_t};
  for (std::size_t i = 0; i < count; i += kLanes) {
    const WordVec pairs = hn::LoadU(w, s.pairs + i);
    const LaneHits hits = meet_spheres<false>(
        listed_rays(s, s.pairs + i), choose_spheres(leaf, hn::ShiftRight<kNumberBits>(pairs)));
    const FloatMask mask = hn::And(hits.mask, hn::FirstN(Floats(), count - i));
    found.append(pairs, mask);
    distances.append(bits_of_floats(hits.t), mask);
  }
  return found.count;
}

// Keeps the nearest hits: the smaller of distance and id as one number. For any hit the first one
// ends a ray's search.
template <bool kAnyHit>
HWY_INLINE void keep_found(ChildRef ref, const std::uint32_t* ids, std::size_t count,
                           StreamScratch& s) {
  const auto first_word = static_cast<std::uint32_t>(ref.leaf_ref().bits);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t ray = s.found[i] & kNumberMask, lane = s.found[i] >> kNumberBits;
    const std::uint64_t hit = std::uint64_t{s.found_t[i]} << 32 | ids[lane];
    const std::uint64_t before = s.best[ray];
    const bool better = hit < before;
    const std::uint64_t best = better ? hit : before;
    s.best[ray] = best;
    s.lane[ray] = better ? first_word | lane : s.lane[ray];
    const auto t = kAnyHit ? 0xbf800000u : static_cast<std::uint32_t>(best >> 32);  // -1
    __builtin_memcpy(s.inverse + 4 * std::size_t{ray} + 3, &t, sizeof t);
  }
}

template <bool kAnyHit>
HWY_INLINE void visit_spheres(const LeafRow* leaf, ChildRef ref, const RayList& list,
                              StreamScratch& s) {
  const CoarseSpheres spheres = coarsen(leaf);
  const std::uint32_t* ids = leaf[leaf_id_row(ShapeKind::sphere)].words;
  for (std::size_t begin = 0; begin < list.count; begin += kLeafPiece) {
    const std::size_t left = list.count - begin;
    const RayList piece = {list.rays + begin, left < kLeafPiece ? left : kLeafPiece};
    const std::size_t pairs = list_pairs(spheres, piece, s);
    keep_found<kAnyHit>(ref, ids, meet_pairs(leaf, pairs, s), s);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
