// Paths, one a lane, and the way between arrays of structs in memory and lanes.
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
  WordVec x, y, sample;
};

// The first `count` lanes.
HWY_INLINE FloatMask first_lanes(std::size_t count) { return hn::FirstN(Floats(), count); }

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE void load_rays(const Ray* rays, PathVec& path) {
  path.origin = all(rays->origin);
  path.direction = all(rays->direction);
}
HWY_INLINE void store_rays(const PathVec& path, Ray* rays) {
  rays->origin = {hn::GetLane(path.origin.x), hn::GetLane(path.origin.y),
                  hn::GetLane(path.origin.z)};
  rays->t_min = kRayTMin;
  rays->direction = {hn::GetLane(path.direction.x), hn::GetLane(path.direction.y),
                     hn::GetLane(path.direction.z)};
  rays->t_max = Bounds3f::kInfinity;
}

#else

// Rays stand as origins and directions in turn, each with its bound, four words together.
HWY_INLINE void load_rays(const Ray* rays, PathVec& path) {
  const Floats d;
  const float* words = &rays->origin.x;
  FloatVec x0, y0, z0, bound, x1, y1, z1;
  hn::LoadInterleaved4(d, words, x0, y0, z0, bound);
  hn::LoadInterleaved4(d, words + 4 * kLanes, x1, y1, z1, bound);
  path.origin = {hn::ConcatEven(d, x1, x0), hn::ConcatEven(d, y1, y0), hn::ConcatEven(d, z1, z0)};
  path.direction = {hn::ConcatOdd(d, x1, x0), hn::ConcatOdd(d, y1, y0), hn::ConcatOdd(d, z1, z0)};
}

HWY_INLINE void store_rays(const PathVec& path, Ray* rays) {
  const Floats d;
  HWY_ALIGN float origins[4 * kLanes];
  HWY_ALIGN float directions[4 * kLanes];
  hn::StoreInterleaved4(path.origin.x, path.origin.y, path.origin.z, all(kRayTMin), d, origins);
  hn::StoreInterleaved4(path.direction.x, path.direction.y, path.direction.z,
                        all(Bounds3f::kInfinity), d, directions);
  const hn::FixedTag<float, 4> quarter;
  for (std::size_t i = 0; i < kLanes; ++i) {
    hn::StoreU(hn::Load(quarter, origins + 4 * i), quarter, &rays[i].origin.x);
    hn::StoreU(hn::Load(quarter, directions + 4 * i), quarter, &rays[i].direction.x);
  }
}

#endif

HWY_INLINE PathVec load_paths(const PathArrays& paths, std::size_t i) {
  const Words d;
  PathVec path;
  load_rays(paths.rays + i, path);
  path.throughput = {load_floats(paths.throughput[0] + i), load_floats(paths.throughput[1] + i),
                     load_floats(paths.throughput[2] + i)};
  path.x = hn::Load(d, paths.x + i);
  path.y = hn::Load(d, paths.y + i);
  path.sample = hn::Load(d, paths.sample + i);
  return path;
}

// Writes whole vectors from element i on, where the padding or paths already read may be.
HWY_INLINE void store_paths(const PathVec& path, const PathArrays& paths, std::size_t i) {
  const Floats df;
  const Words dw;
  store_rays(path, paths.rays + i);
  hn::StoreU(path.throughput.x, df, paths.throughput[0] + i);
  hn::StoreU(path.throughput.y, df, paths.throughput[1] + i);
  hn::StoreU(path.throughput.z, df, paths.throughput[2] + i);
  hn::StoreU(path.x, dw, paths.x + i);
  hn::StoreU(path.y, dw, paths.y + i);
  hn::StoreU(path.sample, dw, paths.sample + i);
}

HWY_INLINE FloatVec3 compress(FloatVec3 v, FloatMask mask) {
  return {hn::Compress(v.x, mask), hn::Compress(v.y, mask), hn::Compress(v.z, mask)};
}

// Lanes in the mask come first, in their order.
HWY_INLINE PathVec compress(const PathVec& path, FloatMask mask) {
  const WordMask words = word_mask(mask);
  return {compress(path.origin, mask),     compress(path.direction, mask),
          compress(path.throughput, mask), hn::Compress(path.x, words),
          hn::Compress(path.y, words),     hn::Compress(path.sample, words)};
}

// Vectors of fields that fill up lane by lane, until kLanes elements can be taken at once.
template <std::size_t kFields>
struct LaneQueue {
  HWY_ALIGN std::uint32_t words[kFields][2 * kLanes] = {};
  std::size_t count = 0;

  // At most kLanes - 1 elements may be there.
  HWY_INLINE void append(std::size_t field, WordVec values, WordMask mask) {
    hn::StoreU(hn::Compress(values, mask), Words(), words[field] + count);
  }
  HWY_INLINE void append(std::size_t field, FloatVec3 values, WordMask mask) {
    append(field, bits_of_floats(values.x), mask);
    append(field + 1, bits_of_floats(values.y), mask);
    append(field + 2, bits_of_floats(values.z), mask);
  }
  HWY_INLINE WordVec words_of(std::size_t field) const { return hn::Load(Words(), words[field]); }
  HWY_INLINE FloatVec floats_of(std::size_t field) const { return floats_of_bits(words_of(field)); }
  HWY_INLINE FloatVec3 vector_of(std::size_t field) const {
    return {floats_of(field), floats_of(field + 1), floats_of(field + 2)};
  }
  // Drops the first kLanes elements.
  HWY_INLINE void take() {
    for (std::size_t f = 0; f < kFields; ++f) {
      hn::Store(hn::Load(Words(), words[f] + kLanes), Words(), words[f]);
    }
    count -= kLanes;
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
