// CameraRays::generate for one sample a lane.
#include "math/warps-inl.h"
#include "render/kernels/film-inl.h"
#include "render/kernels/path_lanes-inl.h"

#if defined(DAPPLE_RENDER_CAMERA_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef DAPPLE_RENDER_CAMERA_INL_H
#undef DAPPLE_RENDER_CAMERA_INL_H
#else
#define DAPPLE_RENDER_CAMERA_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace dapple {
namespace HWY_NAMESPACE {

HWY_INLINE void generate(const CameraFrame& camera, WordVec x, WordVec y, const UniformVec4& u,
                         PathVec& path) {
  const DiscPoint lens = sample_uniform_disc(u.u2, u.u3);
  const FloatVec3 offset = lens.x * all(camera.lens_u) + lens.y * all(camera.lens_v);
  const FloatVec column = hn::Add(to_floats(x), u.u0);
  const FloatVec row = hn::Add(to_floats(y), u.u1);
  path.origin = all(camera.origin) + offset;
  path.direction =
      all(camera.corner) + column * all(camera.per_column) + row * all(camera.per_row) - offset;
}

// Lanes cover some columns of a strip and, if there are more, its next rows.
inline constexpr std::uint32_t kLaneColumns = kPixelRun;
inline constexpr std::uint32_t kLaneRows = kLanes / kLaneColumns;
static_assert(kLaneRows == 1 || kLaneColumns == 1 << 3);

// Counted from the unit's first ones.
struct PixelSample {
  std::uint32_t column, row, sample;
};

// Starts one sample of each of kLanes pixels, where they are inside the tile.
HWY_INLINE void start_pixels(const CameraFrame& camera, const PathUnit& unit,
                             const PixelSample& first, std::uint64_t seed, PathArrays& paths) {
  const auto word = [](int i) { return static_cast<std::uint32_t>(i); };
  const WordVec lane = words_from(0), lane_column = hn::And(lane, all_words(kLaneColumns - 1));
  const WordVec lane_row = kLaneRows == 1 ? hn::Zero(Words()) : hn::ShiftRight<3>(lane);
  const WordVec columns = hn::Add(all_words(first.column), lane_column);
  const WordVec rows = hn::Add(all_words(first.row), lane_row);
  const WordVec x = hn::Add(all_words(word(unit.tile.x0)), columns);
  const WordVec y = hn::Add(all_words(word(unit.tile.y0)), rows);
  const WordVec samples = all_words(word(unit.samples.begin) + first.sample);
  PathVec path;
  generate(camera, x, y, uniform4({x, y, samples, kCameraDimension, seed}), path);
  path.throughput = {all(1.0f), all(1.0f), all(1.0f)};
  path.place = hn::Or(columns, hn::Or(hn::ShiftLeft<kColumnBits>(rows),
                                      all_words(first.sample << (kColumnBits + kRowBits))));
  const FloatMask inside = float_mask(hn::And(hn::Lt(columns, all_words(word(unit.tile.width()))),
                                              hn::Lt(rows, all_words(word(unit.tile.height())))));
  const bool all_inside = hn::AllTrue(Floats(), inside);
  store_paths(all_inside ? path : compress(path, inside), paths, paths.count);
  paths.count += hn::CountTrue(Floats(), inside);
}

HWY_ATTR void start_paths(const CameraFrame& camera, const PathUnit& unit, std::uint64_t seed,
                          PathArrays& paths) {
  const auto width = static_cast<std::uint32_t>(unit.tile.width());
  const auto height = static_cast<std::uint32_t>(unit.tile.height());
  const auto samples = static_cast<std::uint32_t>(unit.samples.end - unit.samples.begin);
  paths.count = 0;
  for (std::uint32_t strip = 0; strip < width; strip += kStripColumns) {
    for (std::uint32_t row = 0; row < height; row += kLaneRows) {
      for (std::uint32_t sample = 0; sample < samples; ++sample) {
        for (std::uint32_t i = 0; i < kStripColumns && strip + i < width; i += kLaneColumns) {
          start_pixels(camera, unit, {strip + i, row, sample}, seed, paths);
        }
      }
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
