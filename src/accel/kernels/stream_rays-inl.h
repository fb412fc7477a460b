// The rays of a stream: by number, in lists.
#include "accel/kernels/prepare-inl.h"
#include "accel/kernels/search-inl.h"
#include "accel/kernels/stream_scratch.h"
#include "math/compress-inl.h"
#include "math/quads-inl.h"

#if defined(DAPPLE_KERNELS_STREAM_RAYS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_KERNELS_STREAM_RAYS_INL_H
#undef DAPPLE_KERNELS_STREAM_RAYS_INL_H
#else
#define DAPPLE_KERNELS_STREAM_RAYS_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

// A ray in a list: its number, and above that something small or the upper bits of a distance,
// which thereby gets a little smaller.
inline constexpr int kNumberBits = 13;
inline constexpr std::uint32_t kNumberMask = (1u << kNumberBits) - 1;
static_assert(kStreamRays == 1u << kNumberBits);

HWY_INLINE WordVec numbers_of(WordVec listed) { return hn::And(listed, all_words(kNumberMask)); }
HWY_INLINE FloatVec distances_of(WordVec listed) {
  return floats_of_bits(hn::AndNot(all_words(kNumberMask), listed));
}
HWY_INLINE WordVec with_distances(WordVec numbers, FloatVec distances) {
  return hn::Or(numbers, hn::AndNot(all_words(kNumberMask), bits_of_floats(distances)));
}

// Behind the last ray stand zeros up to the end of a vector: the number of some ray.
struct RayList {
  std::uint32_t* rays;
  std::size_t count = 0;

  HWY_INLINE void append(WordVec listed, FloatMask mask) {
    hn::StoreU(compress(listed, mask), Words(), rays + count);
    count += hn::CountTrue(Floats(), mask);
  }
  HWY_INLINE void pad() const { hn::StoreU(hn::Zero(Words()), Words(), rays + count); }
  HWY_INLINE FloatMask there(std::size_t i) const { return hn::FirstN(Floats(), count - i); }
};

// The numbers of listed rays [0, kLanes) in one of the arrays of quads.
HWY_INLINE Quads load_quads(const float* quads, const std::uint32_t* listed) {
  return load_quads(
      [=](std::size_t i) { return quads + 4 * std::size_t{listed[i] & kNumberMask}; });
}

// Rays from[0] to from[kBatch - 1] as those with numbers `first` and on, in the lists of their
// octants.
HWY_INLINE void add_to_stream(const Ray* from, std::size_t first, StreamScratch& s) {
  const Floats d;
  for (std::size_t i = 0; i < kBatch; i += kLanes) {
    const RayLanes rays = load_rays(from + i);
    const std::size_t at = first + i;
    hn::StoreInterleaved4(rays.origin[0], rays.origin[1], rays.origin[2], rays.t_min, d,
                          s.origin + 4 * at);
    hn::StoreInterleaved4(rays.inverse[0], rays.inverse[1], rays.inverse[2], rays.t_max, d,
                          s.inverse + 4 * at);
    hn::StoreInterleaved4(rays.direction[0], rays.direction[1], rays.direction[2], rays.inverse_dot,
                          d, s.direction + 4 * at);
    hn::StoreInterleaved2(all_words(kNoPrim), bits_of_floats(rays.t_max), Words(),
                          reinterpret_cast<std::uint32_t*>(s.best + at));
    const WordVec numbers = words_from(static_cast<std::uint32_t>(at));
    FloatMask along[3][2];  // upwards and downwards
    for (std::size_t axis = 0; axis < 3; ++axis) {
      along[axis][1] = hn::Lt(rays.inverse[axis], hn::Zero(d));
      along[axis][0] = hn::Not(along[axis][1]);
    }
    for (std::uint32_t signs = 0; signs < 8; ++signs) {
      RayList list = {s.octants[signs], s.octant_counts[signs]};
      list.append(numbers, hn::And(along[0][signs & 1],
                                   hn::And(along[1][signs >> 1 & 1], along[2][signs >> 2])));
      s.octant_counts[signs] = static_cast<std::uint32_t>(list.count);
    }
  }
}

// Takes rays from a list of entry distances that have found something nearer; leaves numbers only.
HWY_INLINE void drop_settled(const StreamScratch& s, RayList& list) {
  const Words d;
  RayList kept = {list.rays};
  for (std::size_t i = 0; i < list.count; i += kLanes) {
    const WordVec listed = hn::LoadU(d, list.rays + i);
    const WordVec numbers = numbers_of(listed);
    const FloatVec best =
        hn::GatherIndex(Floats(), s.inverse + 3, hn::BitCast(Ints(), hn::ShiftLeft<2>(numbers)));
    kept.append(numbers, hn::And(list.there(i), hn::Le(distances_of(listed), best)));
  }
  list = kept;
  list.pad();
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
