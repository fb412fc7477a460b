// From hits to the next rays, or to the film.
//
// Paths that hit nothing and paths that hit something wait in queues of their own, so that each
// stage works on full vectors.
#include "accel/kernels/locate-inl.h"
#include "render/kernels/film-inl.h"
#include "render/kernels/path_lanes-inl.h"
#include "shading/scatter-inl.h"

#if defined(DAPPLE_RENDER_SCATTER_PATHS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_RENDER_SCATTER_PATHS_INL_H
#undef DAPPLE_RENDER_SCATTER_PATHS_INL_H
#else
#define DAPPLE_RENDER_SCATTER_PATHS_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

HWY_INLINE FloatVec3 sky(FloatVec3 direction) {
  const FloatVec one = all(1.0f), half = all(0.5f);
  const FloatVec height = hn::Div(direction.y, length(direction));
  const FloatVec t = hn::Mul(half, hn::Add(height, one));
  const FloatVec white = hn::Sub(one, t);
  return {hn::Add(white, hn::Mul(t, half)), hn::Add(white, hn::Mul(t, all(0.7f))),
          hn::Add(white, t)};
}

// Fields: direction 0, throughput 3, x 6, y 7.
using MissQueue = LaneQueue<8>;

HWY_INLINE void add_misses(const MissQueue& misses, std::size_t count, TileSums& sums) {
  add_to_film(misses.vector_of(3) * sky(misses.vector_of(0)), misses.words_of(6),
              misses.words_of(7), count, sums);
}

HWY_INLINE void append_misses(const PathVec& path, FloatMask missed, MissQueue& misses) {
  const WordMask mask = word_mask(missed);
  misses.append(0, path.direction, mask);
  misses.append(3, path.throughput, mask);
  misses.append(6, path.x, mask);
  misses.append(7, path.y, mask);
  misses.count += hn::CountTrue(Floats(), missed);
}

// Fields: origin 0, direction 3, throughput 6, x 9, y 10, sample 11, t 12, prim 13, lane 14 and 15.
using HitQueue = LaneQueue<16>;

struct HitWords {
  WordVec t, prim, low, high;
};

HWY_INLINE void append_hits(const PathVec& path, const HitWords& hit, FloatMask found,
                            HitQueue& hits) {
  const WordMask mask = word_mask(found);
  hits.append(0, path.origin, mask);
  hits.append(3, path.direction, mask);
  hits.append(6, path.throughput, mask);
  hits.append(9, path.x, mask);
  hits.append(10, path.y, mask);
  hits.append(11, path.sample, mask);
  hits.append(12, hit.t, mask);
  hits.append(13, hit.prim, mask);
  hits.append(14, hit.low, mask);
  hits.append(15, hit.high, mask);
  hits.count += hn::CountTrue(Floats(), found);
}

// For each kind that occurs `there`, other lanes look up index 0 and are masked out.
HWY_INLINE WordVec material_ids(const SurfaceView& surfaces, WordVec prim, WordVec kind,
                                WordMask there) {
  WordVec ids = hn::Zero(Words());
  for (std::uint32_t k = 0; k < kShapeKindCount; ++k) {
    const WordMask of_kind = hn::And(there, hn::Eq(kind, all_words(k)));
    if (hn::AllFalse(Words(), of_kind)) continue;
    const WordVec index =
        hn::IfThenElseZero(of_kind, hn::Sub(prim, all_words(surfaces.first_ids[k])));
    const auto* words = reinterpret_cast<const std::uint32_t*>(surfaces.materials_of[k]);
    ids = hn::IfThenElse(of_kind, gather(words, index), ids);
  }
  return ids;
}

HWY_INLINE MaterialVec materials_of(const SurfaceView& surfaces, WordVec prim, WordVec lane_high,
                                    FloatMask there) {
  WordVec ids = hn::Zero(Words());
  if (surfaces.material_count > 1) {
    ids = material_ids(surfaces, prim, hn::ShiftRight<28>(lane_high), word_mask(there));
  }
  return load_materials(surfaces.materials, ids);
}

struct Bounce {
  const SurfaceView& surfaces;
  std::uint32_t dimension;
  std::uint64_t seed;
};

// Scatters the first `count` paths of the queue and stores those that go on.
HWY_INLINE void scatter_hits(const Bounce& bounce, const HitQueue& hits, std::size_t count,
                             PathArrays& paths) {
  const FloatVec zero = hn::Zero(Floats());
  const FloatMask there = first_lanes(count);
  PathVec path = {hits.vector_of(0), hits.vector_of(3), hits.vector_of(6),
                  hits.words_of(9),  hits.words_of(10), hits.words_of(11)};
  const SurfacePointVec at = locate(
      bounce.surfaces.leaves, bounce.surfaces.instances,
      {path.origin, path.direction, hits.floats_of(12), hits.words_of(14), hits.words_of(15)});
  const FloatMask from_outside = hn::Lt(dot(path.direction, at.outward), zero);
  const FloatVec3 normal = select(from_outside, at.outward, -at.outward);
  const MaterialVec material =
      materials_of(bounce.surfaces, hits.words_of(13), hits.words_of(15), there);
  const ScatteredVec scattered =
      scatter(material, {normalize(path.direction), normal, from_outside},
              {path.x, path.y, path.sample, bounce.dimension, bounce.seed});
  path.throughput = path.throughput * material.albedo;
  // Starting a little off the surface, on the side the ray leaves to, keeps it from being hit
  // again where single precision puts it on the wrong side.
  const FloatMask same_side = hn::Ge(dot(scattered.direction, normal), zero);
  const FloatVec side = hn::IfThenElse(same_side, at.error, hn::Neg(at.error));
  path.origin = at.position + side * normal;
  path.direction = scattered.direction;
  const FloatMask goes_on = hn::AndNot(scattered.absorbed, there);
  const bool all_go_on = hn::AllTrue(Floats(), goes_on);
  store_paths(all_go_on ? path : compress(path, goes_on), paths, paths.count);
  paths.count += hn::CountTrue(Floats(), goes_on);
}

HWY_ATTR void scatter_paths(const SurfaceView& surfaces, std::uint32_t dimension,
                            std::uint64_t seed, PathArrays& paths, TileSums& sums) {
  const Bounce bounce = {surfaces, dimension, seed};
  HitQueue hits;
  MissQueue misses;
  const std::size_t count = paths.count;
  paths.count = 0;  // never beyond what was read
  for (std::size_t i = 0; i < count; i += kLanes) {
    const PathVec path = load_paths(paths, i);
    HitWords hit;
    hn::LoadInterleaved4(Words(), reinterpret_cast<const std::uint32_t*>(paths.hits + i), hit.t,
                         hit.prim, hit.low, hit.high);
    const FloatMask there = first_lanes(count - i);
    const FloatMask none = float_mask(hn::Eq(hit.prim, all_words(kNoPrim)));
    append_misses(path, hn::And(none, there), misses);
    append_hits(path, hit, hn::AndNot(none, there), hits);
    if (misses.count >= kLanes) {
      add_misses(misses, kLanes, sums);
      misses.take();
    }
    if (hits.count >= kLanes) {
      scatter_hits(bounce, hits, kLanes, paths);
      hits.take();
    }
  }
  if (misses.count != 0) add_misses(misses, misses.count, sums);
  if (hits.count != 0) scatter_hits(bounce, hits, hits.count, paths);
}

HWY_ATTR void cut_paths(const PathArrays& paths, TileSums& sums) {
  for (std::size_t i = 0; i < paths.count; i += kLanes) {
    const std::size_t left = paths.count - i;
    const FloatVec3 throughput = {load_floats(paths.throughput[0] + i),
                                  load_floats(paths.throughput[1] + i),
                                  load_floats(paths.throughput[2] + i)};
    add_to_film(throughput, hn::Load(Words(), paths.x + i), hn::Load(Words(), paths.y + i),
                left < kLanes ? left : kLanes, sums);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
