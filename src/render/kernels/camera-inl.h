// CameraRays::generate for one sample a lane.
#include "math/warps-inl.h"
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

HWY_INLINE void generate(const CameraFrame& camera, const UniformVec4& u, PathVec& path) {
  const DiscPoint lens = sample_uniform_disc(u.u2, u.u3);
  const FloatVec3 offset = lens.x * all(camera.lens_u) + lens.y * all(camera.lens_v);
  const FloatVec column = hn::Add(to_floats(path.x), u.u0);
  const FloatVec row = hn::Add(to_floats(path.y), u.u1);
  path.origin = all(camera.origin) + offset;
  path.direction =
      all(camera.corner) + column * all(camera.per_column) + row * all(camera.per_row) - offset;
}

// Columns [begin, end) of a row.
HWY_INLINE void start_row(const CameraFrame& camera, int begin, int end, int y, int sample,
                          std::uint64_t seed, PathArrays& paths) {
  const FloatVec one = all(1.0f);
  PathVec path;
  path.throughput = {one, one, one};
  path.y = all_words(static_cast<std::uint32_t>(y));
  path.sample = all_words(static_cast<std::uint32_t>(sample));
  for (int x = begin; x < end; x += static_cast<int>(kLanes)) {
    path.x = words_from(static_cast<std::uint32_t>(x));
    generate(camera, uniform4({path.x, path.y, path.sample, kCameraDimension, seed}), path);
    store_paths(path, paths, paths.count);
    const auto left = static_cast<std::size_t>(end - x);
    paths.count += left < kLanes ? left : kLanes;
  }
}

// The rays of 64 paths in a row go much the same way, which the traversal makes use of: few
// columns, then all samples, before the next row.
inline constexpr int kColumns = 16;

HWY_ATTR void start_paths(const CameraFrame& camera, const Tile& tile, SampleRange samples,
                          std::uint64_t seed, PathArrays& paths) {
  paths.count = 0;
  for (int x = tile.x0; x < tile.x1; x += kColumns) {
    const int end = x + kColumns < tile.x1 ? x + kColumns : tile.x1;
    for (int y = tile.y0; y < tile.y1; ++y) {
      for (int sample = samples.begin; sample < samples.end; ++sample) {
        start_row(camera, x, end, y, sample, seed, paths);
      }
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace dapple
HWY_AFTER_NAMESPACE();
#endif
