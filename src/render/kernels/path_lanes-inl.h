// Paths, one a lane, and the way between arrays of structs in memory and lanes.
#include "math/compress-inl.h"
#include "math/quads-inl.h"
#include "math/random-inl.h"
#include "render/kernels/path_kernels.h"

#if defined(DAPPLE_RENDER_PATH_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_RENDER_PATH_LANES_INL_H
#undef DAPPLE_RENDER_PATH_LANES_INL_H
#else
#define DAPPLE_RENDER_PATH_LANES_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

struct PathVec {
  FloatVec3 origin, direction, throughput;
  WordVec place;
};

// Column, row and sample, counted from the unit's first ones.
HWY_INLINE WordVec columns_of(WordVec place) { return hn::And(place, all_words(kMostColumns - 1)); }
HWY_INLINE WordVec rows_of(WordVec place) {
  return hn::And(hn::ShiftRight<kColumnBits>(place), all_words(kMostRows - 1));
}
HWY_INLINE WordVec samples_of(WordVec place) {
  return hn::ShiftRight<kColumnBits + kRowBits>(place);
}

// The first `count` lanes.
HWY_INLINE FloatMask first_lanes(std::size_t count) { return hn::FirstN(Floats(), count); }

HWY_INLINE void load_rays(const Ray* rays, PathVec& path) {
  const Quads origins = load_quads([=](std::size_t i) { return &rays[i].origin.x; });
  const Quads directions = load_quads([=](std::size_t i) { return &rays[i].direction.x; });
  path.origin = {origins.of[0], origins.of[1], origins.of[2]};
  path.direction = {directions.of[0], directions.of[1], directions.of[2]};
}

HWY_INLINE void store_rays(const PathVec& path, Ray* rays) {
  const FloatVec3 o = path.origin, d = path.direction;
  store_quads({{o.x, o.y, o.z, all(kRayTMin)}}, [=](std::size_t i) { return &rays[i].origin.x; });
  store_quads({{d.x, d.y, d.z, all(Bounds3f::kInfinity)}},
              [=](std::size_t i) { return &rays[i].direction.x; });
}

HWY_INLINE PathVec load_paths(const PathArrays& paths, std::size_t i) {
  PathVec path;
  load_rays(paths.rays + i, path);
  path.throughput = {load_floats(paths.throughput[0] + i), load_floats(paths.throughput[1] + i),
                     load_floats(paths.throughput[2] + i)};
  path.place = hn::Load(Words(), paths.place + i);
  return path;
}

// Writes whole vectors from element i on, where the padding or paths already read may be.
HWY_INLINE void store_paths(const PathVec& path, const PathArrays& paths, std::size_t i) {
  const Floats df;
  store_rays(path, paths.rays + i);
  hn::StoreU(path.throughput.x, df, paths.throughput[0] + i);
  hn::StoreU(path.throughput.y, df, paths.throughput[1] + i);
  hn::StoreU(path.throughput.z, df, paths.throughput[2] + i);
  hn::StoreU(path.place, Words(), paths.place + i);
}

// Lanes in the mask come first, in their order.
HWY_INLINE PathVec compress(const PathVec& path, FloatMask mask) {
  return {compress(path.origin, mask), compress(path.direction, mask),
          compress(path.throughput, mask), compress(path.place, mask)};
}

// Fields that fill up lane by lane, until they are taken as whole vectors. Many vectors at once:
// what was stored a moment ago at another offset is slow to load.
template <std::size_t kFields>
struct LaneQueue {
  static constexpr std::size_t kCapacity = 8 * kLanes;

  HWY_ALIGN std::uint32_t words[kFields][kCapacity] = {};
  std::size_t count = 0;

  // Not to be appended to before elements were taken.
  HWY_INLINE bool full() const { return count > kCapacity - kLanes; }

  // Appends the lanes of a mask, field by field.
  class Appender {
   public:
    HWY_INLINE Appender(LaneQueue& queue, FloatMask mask)
        : end_(queue.words[0] + queue.count), mask_(mask) {
      queue.count += hn::CountTrue(Floats(), mask);
    }
    HWY_INLINE void operator()(std::size_t field, WordVec values) const {
      hn::StoreU(compress(values, mask_), Words(), end_ + field * kCapacity);
    }
    HWY_INLINE void operator()(std::size_t field, FloatVec3 values) const {
      (*this)(field, bits_of_floats(values.x));
      (*this)(field + 1, bits_of_floats(values.y));
      (*this)(field + 2, bits_of_floats(values.z));
    }

   private:
    std::uint32_t* end_;
    FloatMask mask_;
  };

  // Elements [i, i + kLanes), for i a multiple of kLanes.
  HWY_INLINE WordVec words_of(std::size_t field, std::size_t i) const {
    return hn::Load(Words(), words[field] + i);
  }
  HWY_INLINE FloatVec floats_of(std::size_t field, std::size_t i) const {
    return floats_of_bits(words_of(field, i));
  }
  HWY_INLINE FloatVec3 vector_of(std::size_t field, std::size_t i) const {
    return {floats_of(field, i), floats_of(field + 1, i), floats_of(field + 2, i)};
  }
  // Calls take(i, kLanes) for all whole vectors and drops their elements.
  template <class Take>
  HWY_INLINE void take_vectors(Take take) {
    std::size_t i = 0;
    for (; i + kLanes <= count; i += kLanes) take(i, kLanes);
    count -= i;
    if (i == kCapacity) return;
    for (std::size_t f = 0; f < kFields; ++f) hn::Store(words_of(f, i), Words(), words[f]);
  }
  // The same for all elements, of which the last vector may have fewer.
  template <class Take>
  HWY_INLINE void take_all(Take take) {
    for (std::size_t i = 0; i < count; i += kLanes) {
      take(i, count - i < kLanes ? count - i : kLanes);
    }
    count = 0;
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
