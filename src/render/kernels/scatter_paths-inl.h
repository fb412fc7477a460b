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

// The number of a path's pixel in its tile.
HWY_INLINE WordVec pixels_of(WordVec place, const Tile& tile) {
  const WordVec width = all_words(static_cast<std::uint32_t>(tile.width()));
  return hn::Add(hn::Mul(rows_of(place), width), columns_of(place));
}

// Fields: direction 0, throughput 3, place 6.
using MissQueue = LaneQueue<7>;

// The first `count` lanes.
HWY_INLINE void add_misses(const PathVec& path, std::size_t count, TileSums& sums) {
  add_to_film(path.throughput * sky(path.direction), pixels_of(path.place, sums.tile()), count,
              sums);
}

HWY_INLINE PathVec miss_of(const MissQueue& misses, std::size_t i) {
  PathVec path;
  path.direction = misses.vector_of(0, i);
  path.throughput = misses.vector_of(3, i);
  path.place = misses.words_of(6, i);
  return path;
}

HWY_INLINE void append_misses(const PathVec& path, FloatMask missed, MissQueue& misses) {
  const MissQueue::Appender append(misses, missed);
  append(0, path.direction);
  append(3, path.throughput);
  append(6, path.place);
}

// Fields: origin 0, direction 3, throughput 6, place 9, t 10, prim 11, lane 12 and 13.
using HitQueue = LaneQueue<14>;

struct HitWords {
  WordVec t, prim, low, high;
};

HWY_INLINE void append_hits(const PathVec& path, const HitWords& hit, FloatMask found,
                            HitQueue& hits) {
  const HitQueue::Appender append(hits, found);
  append(0, path.origin);
  append(3, path.direction);
  append(6, path.throughput);
  append(9, path.place);
  append(10, hit.t);
  append(11, hit.prim);
  append(12, hit.low);
  append(13, hit.high);
}

// For each kind that occurs `there`, other lanes look up index 0 and are masked out.
HWY_INLINE WordVec material_ids(const SurfaceView& surfaces, WordVec prim, WordVec kind,
                                WordMask there) {
  WordVec ids = hn::Zero(Words());
  WordMask left = there;
  for (std::uint32_t k = 0; k < kShapeKindCount && !hn::AllFalse(Words(), left); ++k) {
    const WordMask of_kind = hn::And(left, hn::Eq(kind, all_words(k)));
    left = hn::AndNot(of_kind, left);
    if (hn::AllFalse(Words(), of_kind)) continue;
    const WordVec index =
        hn::IfThenElseZero(of_kind, hn::Sub(prim, all_words(surfaces.first_ids[k])));
    const auto* words = reinterpret_cast<const std::uint32_t*>(surfaces.materials_of[k]);
    ids = hn::IfThenElse(of_kind, gather(words, index), ids);
  }
  return ids;
}

HWY_INLINE MaterialVec materials_of(const SurfaceView& surfaces, const MaterialTable& table,
                                    WordVec prim, WordVec lane_high, FloatMask there) {
  WordVec ids = hn::Zero(Words());
  if (surfaces.material_count > 1) {
    ids = material_ids(surfaces, prim, hn::ShiftRight<28>(lane_high), word_mask(there));
  }
  return table[ids];
}

struct Bounce {
  const SurfaceView& surfaces;
  const MaterialTable materials;
  const PathUnit& unit;
  std::uint32_t dimension;
  std::uint64_t seed;

  HWY_INLINE RandomCounters counters(WordVec place) const {
    const auto from = [](int first, WordVec v) HWY_ATTR -> WordVec {
      return hn::Add(all_words(static_cast<std::uint32_t>(first)), v);
    };
    return {from(unit.tile.x0, columns_of(place)), from(unit.tile.y0, rows_of(place)),
            from(unit.samples.begin, samples_of(place)), dimension, seed};
  }
};

HWY_INLINE PathVec path_of(const HitQueue& hits, std::size_t i) {
  return {hits.vector_of(0, i), hits.vector_of(3, i), hits.vector_of(6, i), hits.words_of(9, i)};
}
HWY_INLINE HitWords hit_of(const HitQueue& hits, std::size_t i) {
  return {hits.words_of(10, i), hits.words_of(11, i), hits.words_of(12, i), hits.words_of(13, i)};
}

// Scatters the first `count` lanes and stores those that go on.
HWY_INLINE void scatter_hits(const Bounce& bounce, PathVec path, const HitWords& hit,
                             std::size_t count, PathArrays& paths) {
  const FloatVec zero = hn::Zero(Floats());
  const FloatMask there = first_lanes(count);
  const SurfacePointVec at =
      locate(bounce.surfaces.leaves, bounce.surfaces.instances,
             {path.origin, path.direction, floats_of_bits(hit.t), hit.low, hit.high});
  const FloatMask from_outside = hn::Lt(dot(path.direction, at.outward), zero);
  const FloatVec3 normal = select(from_outside, at.outward, -at.outward);
  const MaterialVec material =
      materials_of(bounce.surfaces, bounce.materials, hit.prim, hit.high, there);
  const ScatteredVec scattered = scatter(
      material, {normalize(path.direction), normal, from_outside}, bounce.counters(path.place));
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

HWY_ATTR void scatter_paths(const SurfaceView& surfaces, const PathUnit& unit,
                            std::uint32_t dimension, std::uint64_t seed, PathArrays& paths,
                            TileSums& sums) {
  const Bounce bounce = {
      surfaces, {surfaces.materials, surfaces.material_count}, unit, dimension, seed};
  HitQueue hits;
  MissQueue misses;
  const auto add = [&](std::size_t i, std::size_t n)
                       HWY_ATTR { add_misses(miss_of(misses, i), n, sums); };
  const auto scatter_on = [&](std::size_t i, std::size_t n) HWY_ATTR {
    scatter_hits(bounce, path_of(hits, i), hit_of(hits, i), n, paths);
  };
  const std::size_t count = paths.count;
  paths.count = 0;  // never beyond what was read
  for (std::size_t i = 0; i < count; i += kLanes) {
    const PathVec path = load_paths(paths, i);
    HitWords hit;
    hn::LoadInterleaved4(Words(), reinterpret_cast<const std::uint32_t*>(paths.hits + i), hit.t,
                         hit.prim, hit.low, hit.high);
    const FloatMask there = first_lanes(count - i);
    const FloatMask none = float_mask(hn::Eq(hit.prim, all_words(kNoPrim)));
    // Whole vectors need not wait.
    if (hn::AllTrue(Floats(), hn::And(none, there))) {
      add_misses(path, kLanes, sums);
      continue;
    }
    if (hn::AllFalse(Floats(), none) && count - i >= kLanes) {
      scatter_hits(bounce, path, hit, kLanes, paths);
      continue;
    }
    append_misses(path, hn::And(none, there), misses);
    append_hits(path, hit, hn::AndNot(none, there), hits);
    if (misses.full()) misses.take_vectors(add);
    if (hits.full()) hits.take_vectors(scatter_on);
  }
  misses.take_all(add);
  hits.take_all(scatter_on);
}

HWY_ATTR void cut_paths(const PathArrays& paths, TileSums& sums) {
  for (std::size_t i = 0; i < paths.count; i += kLanes) {
    const std::size_t left = paths.count - i;
    const FloatVec3 throughput = {load_floats(paths.throughput[0] + i),
                                  load_floats(paths.throughput[1] + i),
                                  load_floats(paths.throughput[2] + i)};
    add_to_film(throughput, pixels_of(hn::Load(Words(), paths.place + i), sums.tile()),
                left < kLanes ? left : kLanes, sums);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
