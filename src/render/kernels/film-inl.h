// TileSums::add for one sample a lane.
#include "math/simd-inl.h"
#include "render/film.h"
#include "render/kernels/path_kernels.h"

#if defined(DAPPLE_RENDER_FILM_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_RENDER_FILM_INL_H
#undef DAPPLE_RENDER_FILM_INL_H
#else
#define DAPPLE_RENDER_FILM_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

// Where and what a block of samples adds.
struct FilmLanes {
  HWY_ALIGN std::uint32_t index[kLanes];  // of the pixel in the tile
  HWY_ALIGN float scaled[3][kLanes];      // in steps, not rounded
  HWY_ALIGN std::uint32_t steps[3][kLanes];
};

HWY_INLINE FloatMask is_finite(FloatVec v) { return hn::Le(hn::Abs(v), all(kLargestFloat)); }

// Rounds to the nearest step, halves up: exact where the result is below 2^31.
HWY_INLINE WordVec round_steps(FloatVec scaled) {
  const WordVec whole = to_words(scaled);
  const FloatMask up = hn::Ge(hn::Sub(scaled, to_floats(whole)), all(0.5f));
  return hn::Add(whole, hn::IfThenElseZero(word_mask(up), all_words(1)));
}

// Returns the lanes whose steps may not fit into a word.
HWY_INLINE FloatMask store_channel(FloatVec radiance, FloatMask counts, int channel,
                                   FilmLanes& lanes) {
  FloatVec value = hn::IfThenElseZero(counts, radiance);
  value = larger(value, hn::Zero(Floats()));
  value = smaller(value, all(kFilmClamp));
  const FloatVec scaled = hn::Mul(value, all(kFilmStepsPerUnit));
  const FloatMask large = hn::Ge(scaled, all(0x1p31f));
  hn::Store(scaled, Floats(), lanes.scaled[channel]);
  hn::Store(round_steps(hn::IfThenZeroElse(large, scaled)), Words(), lanes.steps[channel]);
  return large;
}

HWY_INLINE void sum_words(const FilmLanes& lanes, std::size_t count, std::int64_t* sums) {
  for (std::size_t i = 0; i < count; ++i) {
    std::int64_t* pixel = sums + std::size_t{3} * lanes.index[i];
    for (int channel = 0; channel < 3; ++channel) pixel[channel] += lanes.steps[channel][i];
  }
}

// So many lanes start as pixels side by side, and often end as them.
inline constexpr std::size_t kPixelRun = kLanes < kStripColumns ? kLanes : kStripColumns;

HWY_INLINE bool make_runs(WordVec pixel) {
  const WordVec lane = words_from(0), in_run = hn::And(lane, all_words(kPixelRun - 1));
  const auto first = hn::IndicesFromVec(Words(), hn::Sub(lane, in_run));
  const WordVec run = hn::Add(hn::TableLookupLanes(pixel, first), in_run);
  return hn::AllTrue(Words(), hn::Eq(pixel, run));
}

// sum_words where they are.
HWY_INLINE void sum_runs(const FilmLanes& lanes, std::int64_t* sums) {
  const hn::CappedTag<std::uint64_t, kPixelRun> wide;
  const hn::Rebind<std::uint32_t, decltype(wide)> words;
  HWY_ALIGN std::uint32_t steps[3 * kLanes];
  const auto channel = [&](int i) HWY_ATTR -> WordVec { return hn::Load(Words(), lanes.steps[i]); };
  hn::StoreInterleaved3(channel(0), channel(1), channel(2), Words(), steps);
  for (std::size_t run = 0; run < kLanes; run += kPixelRun) {
    auto* to = reinterpret_cast<std::uint64_t*>(sums) + std::size_t{3} * lanes.index[run];
    for (std::size_t i = 0; i < 3 * kPixelRun; i += hn::MaxLanes(wide)) {
      const auto more = hn::PromoteTo(wide, hn::LoadU(words, steps + 3 * run + i));
      hn::StoreU(hn::Add(hn::LoadU(wide, to + i), more), wide, to + i);
    }
  }
}

HWY_INLINE void sum_large(const FilmLanes& lanes, std::size_t count, std::int64_t* sums) {
  for (std::size_t i = 0; i < count; ++i) {
    std::int64_t* pixel = sums + std::size_t{3} * lanes.index[i];
    for (int channel = 0; channel < 3; ++channel) {
      pixel[channel] +=
          static_cast<std::int64_t>(static_cast<double>(lanes.scaled[channel][i]) + 0.5);
    }
  }
}

HWY_INLINE FloatMask is_too_bright(FloatVec3 radiance) {
  const FloatVec most = all(kFilmClamp);
  return hn::Or(hn::Gt(radiance.x, most),
                hn::Or(hn::Gt(radiance.y, most), hn::Gt(radiance.z, most)));
}

// Adds the first `count` lanes to pixels with these numbers.
HWY_INLINE void add_to_film(FloatVec3 radiance, WordVec pixel, std::size_t count, TileSums& sums) {
  const FloatMask finite =
      hn::And(is_finite(radiance.x), hn::And(is_finite(radiance.y), is_finite(radiance.z)));
  FilmLanes lanes;
  hn::Store(pixel, Words(), lanes.index);
  const FloatMask large = hn::Or(store_channel(radiance.x, finite, 0, lanes),
                                 hn::Or(store_channel(radiance.y, finite, 1, lanes),
                                        store_channel(radiance.z, finite, 2, lanes)));
  const FloatMask counted = hn::FirstN(Floats(), count);
  if (HWY_UNLIKELY(any(large))) {
    sum_large(lanes, count, sums.steps());
    const FloatMask added = hn::And(finite, counted);
    sums.cut(hn::CountTrue(Floats(), hn::And(added, is_too_bright(radiance))));
  } else if (count == kLanes && make_runs(pixel)) {
    sum_runs(lanes, sums.steps());
  } else {
    sum_words(lanes, count, sums.steps());
  }
  sums.drop(hn::CountTrue(Floats(), hn::AndNot(finite, counted)));
}

// values[i] = sums[i] * scale, rounded to double precision twice and then to single.
HWY_ATTR void average_sums(const std::int64_t* sums, std::size_t count, double scale,
                           float* values) {
  const hn::CappedTag<double, 8> doubles;
  const hn::RebindToSigned<decltype(doubles)> words;
  const hn::Rebind<float, decltype(doubles)> floats;
  const std::size_t lanes = hn::MaxLanes(doubles);
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    const auto sum = hn::ConvertTo(doubles, hn::LoadU(words, sums + i));
    hn::StoreU(hn::DemoteTo(floats, hn::Mul(sum, hn::Set(doubles, scale))), floats, values + i);
  }
  for (; i < count; ++i) values[i] = static_cast<float>(static_cast<double>(sums[i]) * scale);
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
